//! Solutions of the all-orders reference, kept in a folder between runs.
//!
//! Nothing here can change a result or make a run fail: what cannot be read is solved again, what cannot be
//! written is not kept, and either is said on stderr.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use etcetera::BaseStrategy;
use welkin::AtmosphereParams;
use welkin::reference::multiple::{Orders, Settings};

use crate::args::cache::CacheArgs;
use crate::output::Destination;

/// Where solutions are kept, and what came of it.
pub struct Cache {
    folder: Option<PathBuf>,
    reused: usize,
    solved: usize,
    notes: Vec<String>,
}

impl Cache {
    /// Keeps them in the folder that is asked for, or in `welkin` in the user's cache folder.
    pub fn new(args: &CacheArgs) -> Self {
        let mut cache = Self { folder: None, reused: 0, solved: 0, notes: Vec::new() };
        if args.no_cache {
            return cache;
        }
        cache.folder = args.cache_dir.clone();
        if cache.folder.is_none() {
            match etcetera::choose_base_strategy() {
                Ok(folders) => cache.folder = Some(folders.cache_dir().join("welkin")),
                Err(e) => cache.notes.push(format!("solutions of the reference are not kept: {e}")),
            }
        }
        cache
    }

    /// A kept solution, or a new one, which is kept. `progress` hears the fraction that is done, 0 to 1.
    pub fn solve(
        &mut self,
        params: &AtmosphereParams,
        settings: Settings,
        progress: &dyn Fn(f32),
    ) -> welkin::Result<Orders> {
        let path =
            self.folder.as_ref().map(|f| f.join(format!("orders-{:032x}", Orders::key(params, &settings))));
        if let Some(path) = &path {
            match restore(path, params, settings) {
                Ok(Some(orders)) => {
                    self.reused += 1;
                    return Ok(orders);
                }
                Ok(None) => {}
                Err(e) => self.notes.push(format!("{} is not used, solved again: {e}", path.display())),
            }
        }
        // Each order is a nearly constant fraction of the one before it.
        let end = settings.tolerance.ln();
        let orders = Orders::solve(params, settings, |p| progress((p.change.max(1e-300).ln() / end) as f32))?;
        self.solved += 1;
        if let Some(path) = &path
            && let Err(e) = keep(path, &orders)
        {
            self.notes.push(format!("the solution is not kept: {e:#}"));
        }
        Ok(orders)
    }

    /// Where solutions came from, for the line that reports the result: " (1 of 2 solutions from the cache)".
    pub fn summary(&self) -> String {
        match (self.reused, self.reused + self.solved) {
            (0, _) => String::new(),
            (1, 1) => " (solution from the cache)".to_owned(),
            (reused, all) => format!(" ({reused} of {all} solutions from the cache)"),
        }
    }

    /// Prints on stderr what went wrong.
    pub fn print_notes(&mut self) {
        for note in self.notes.drain(..) {
            let _ = writeln!(std::io::stderr(), "note: {note}");
        }
    }
}

/// `None` if there is no such file.
fn restore(path: &Path, params: &AtmosphereParams, settings: Settings) -> anyhow::Result<Option<Orders>> {
    match fs::metadata(path) {
        // Asked first: reading a pipe would wait for its writer.
        Ok(there) => anyhow::ensure!(there.is_file(), "not a file"),
        Err(e) if e.kind() == ErrorKind::NotFound => return Ok(None),
        Err(e) => return Err(e.into()),
    }
    Ok(Some(Orders::from_bytes(&fs::read(path)?, params, settings)?))
}

fn keep(path: &Path, orders: &Orders) -> anyhow::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|e| anyhow::anyhow!("cannot make {}: {e}", folder.display()))?;
    }
    Destination::at(path).write(|file| Ok(file.write_all(&orders.to_bytes())?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SETTINGS: Settings = Settings {
        altitudes: 6,
        sun_angles: 12,
        zeniths: 4,
        azimuths: 6,
        degree: 4,
        max_iterations: 9,
        tolerance: 0.1,
    };

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("welkin-cache-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        folder
    }

    fn cache(folder: &Path) -> Cache {
        Cache::new(&CacheArgs { no_cache: false, cache_dir: Some(folder.to_owned()) })
    }

    /// Solves with a new cache in `folder`; whether that came from there, the solution's bytes, the notes.
    fn ask(folder: &Path, params: &AtmosphereParams, settings: Settings) -> (bool, Vec<u8>, Vec<String>) {
        let mut cache = cache(folder);
        let orders = cache.solve(params, settings, &|_| ()).unwrap();
        assert_eq!(cache.reused + cache.solved, 1);
        (cache.reused == 1, orders.to_bytes(), cache.notes)
    }

    #[test]
    fn a_solution_is_kept_and_only_for_what_it_solves() {
        let folder = folder("kept").join("made/on/demand");
        let earth = AtmosphereParams::earth();
        let (reused, fresh, notes) = ask(&folder, &earth, SETTINGS);
        assert_eq!((reused, notes), (false, vec![]));
        assert_eq!(ask(&folder, &earth, SETTINGS), (true, fresh.clone(), vec![]));
        let dark = AtmosphereParams { ground_albedo: [0.1; 3], ..earth.clone() };
        let finer = Settings { zeniths: 5, ..SETTINGS };
        for (params, settings) in
            [(&dark, SETTINGS), (&earth, finer), (&AtmosphereParams::rayleigh(), SETTINGS)]
        {
            let (reused, other, notes) = ask(&folder, params, settings);
            assert_eq!((reused, notes), (false, vec![]));
            assert!(other != fresh);
        }
        // One file each, and nothing else.
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 4);
        assert_eq!(ask(&folder, &earth, SETTINGS), (true, fresh.clone(), vec![]));
        let mut none = Cache::new(&CacheArgs { no_cache: true, cache_dir: Some(folder.clone()) });
        none.solve(&earth, SETTINGS, &|_| ()).unwrap();
        assert_eq!((none.reused, none.summary()), (0, String::new()));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_is_not_a_solution_is_solved_again_and_mended() {
        let folder = folder("damaged");
        let earth = AtmosphereParams::earth();
        let (_, fresh, _) = ask(&folder, &earth, SETTINGS);
        let file = fs::read_dir(&folder).unwrap().next().unwrap().unwrap().path();
        let mut flipped = fresh.clone();
        let middle = flipped.len() / 2;
        flipped[middle] ^= 1;
        let other = Orders::solve(&AtmosphereParams::rayleigh(), SETTINGS, |_| {}).unwrap().to_bytes();
        for (bytes, why) in [
            (&flipped[..], "damaged"),
            (&fresh[..1000], "damaged"),
            (b"", "not a stored solution"),
            (b"PNG", "not a stored solution"),
            (&other[..], "of another medium"),
        ] {
            fs::write(&file, bytes).unwrap();
            let (reused, again, notes) = ask(&folder, &earth, SETTINGS);
            assert!(!reused && again == fresh, "{why}");
            assert!(
                notes.len() == 1 && notes[0].contains(why) && notes[0].contains("solved again"),
                "{notes:?}"
            );
            assert_eq!(ask(&folder, &earth, SETTINGS), (true, fresh.clone(), vec![]), "not mended: {why}");
        }
        // A folder in the file's place: neither read nor replaced.
        fs::remove_file(&file).unwrap();
        fs::create_dir(&file).unwrap();
        let (reused, again, notes) = ask(&folder, &earth, SETTINGS);
        assert!(!reused && again == fresh && notes.len() == 2, "{notes:?}");
        // Nor is a run stopped by a folder that cannot be made.
        let (reused, again, notes) = ask(&PathBuf::from("/dev/null/below"), &earth, SETTINGS);
        assert!(!reused && again == fresh && notes.last().unwrap().contains("not kept"), "{notes:?}");
        fs::remove_dir_all(folder).unwrap();
    }
}
