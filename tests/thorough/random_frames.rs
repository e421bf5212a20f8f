//! Random frames are finite and possible, on both backends.

use welkin::probe;

use crate::harness::{asked_for, on_both};

const FRAMES: usize = 50;

#[test]
fn random_frames_are_finite_and_possible() {
    on_both(|b| {
        let live = b.live().textures;
        for number in 0..asked_for("WELKIN_SCENES", FRAMES) as u64 {
            let frame = probe::frame(1, number);
            frame.scene.validate().unwrap_or_else(|e| panic!("frame {number}: {e}"));
            if let Some(fault) = probe::look(b, &frame).unwrap() {
                let plainest = probe::shrink_frame(b, &frame).unwrap();
                panic!("{}: frame {number}: {fault:?}, plainest {plainest:#?}", b.info().backend);
            }
        }
        assert_eq!(b.live().textures, live, "textures are left");
    });
}
