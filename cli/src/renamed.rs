//! Commands and options that have another name now, and what it is.

/// Options that have another name now: before and after.
const OPTIONS: [(&str, &str); 1] = [("--out", "--output")];
/// The commands of the laboratory, which were once commands of `welkin`.
const LAB: [&str; 7] = ["accuracy", "stress", "flight", "costs", "film", "compare", "shaders"];
/// The commands of `welkin`.
const WELKIN: [&str; 5] = ["render", "plan", "radiance", "eclipse", "info"];

/// What to write instead of a command that `program` does not have.
pub fn command(program: &str, name: &str) -> Option<String> {
    if program == "welkin" && LAB.contains(&name) {
        Some(format!(
            "'welkin {name}' is now 'welkin-lab {name}'; in the repository run 'cargo lab {name}', which \
             is\n  \
             cargo run --release -p welkin-cli --features lab --bin welkin-lab -- {name}"
        ))
    } else if program == "welkin-lab" && WELKIN.contains(&name) {
        Some(format!(
            "'{name}' is a command of 'welkin'; in the repository run\n  cargo run --release -- {name}"
        ))
    } else {
        None
    }
}

/// What to write instead of an option that no command has.
pub fn option(name: &str) -> Option<String> {
    let (before, after) = OPTIONS.into_iter().find(|(before, _)| *before == name)?;
    Some(format!("'{before}' is now '{after}'"))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    /// The names of a program's commands; clap checks its definition on the way.
    fn commands<C: CommandFactory>() -> Vec<String> {
        let command = C::command();
        command.clone().debug_assert();
        command.get_subcommands().map(|c| c.get_name().to_owned()).collect()
    }

    #[test]
    fn every_command_is_known_to_the_other_program() {
        assert_eq!(commands::<crate::cli::Cli>(), WELKIN);
        #[cfg(feature = "lab")]
        assert_eq!(commands::<crate::lab::cli::Cli>(), LAB);
        for name in LAB {
            assert!(command("welkin", name).is_some_and(|now| now.contains(&format!("cargo lab {name}"))));
            assert_eq!(command("welkin-lab", name), None);
        }
        for name in WELKIN {
            assert!(command("welkin-lab", name).is_some_and(|now| now.contains(&format!("-- {name}"))));
            assert_eq!(command("welkin", name), None);
        }
        assert_eq!(option("--output"), None);
    }
}
