//! Light along a line of pixels or frames, beside the reference's.

/// What was drawn along a line, and what the reference has there.
pub struct Line<'a> {
    pub got: &'a [[f64; 3]],
    pub want: &'a [[f64; 3]],
}

impl Line<'_> {
    fn brightest(&self) -> f64 {
        self.want.iter().flatten().fold(0.0, |m: f64, v| m.max(*v))
    }

    /// Largest second difference of the logarithm of light that the reference does not have; what is less
    /// than a thousandth of the brightest, or what is black at an exposure of 1e5, counts as that.
    pub fn bend(&self) -> f64 {
        let floor = (1e-3 * self.brightest()).max(1e-8);
        let log = |v: &[f64; 3], c: usize| v[c].max(floor).ln();
        let bends = |l: &[[f64; 3]], c: usize| -> Vec<f64> {
            l.windows(3).map(|w| log(&w[0], c) - 2.0 * log(&w[1], c) + log(&w[2], c)).collect()
        };
        (0..3)
            .flat_map(|c| {
                let (got, want) = (bends(self.got, c), bends(self.want, c));
                got.into_iter().zip(want).map(|(g, w)| (g - w).abs()).collect::<Vec<_>>()
            })
            .fold(0.0, f64::max)
    }

    /// [`Self::levels_at`] the exposure that makes the line's brightest value 0.8 of white, at most 1e5.
    pub fn levels(&self) -> f64 {
        self.levels_at((1.6 / self.brightest()).min(1e5))
    }

    /// Largest step between neighbours on a screen of 8 bits, in 255ths, that the reference does not have. Of
    /// light L a screen shows 1 - exp(-L × exposure), with the gamma of 2.2.
    pub fn levels_at(&self, exposure: f64) -> f64 {
        let shown = |v: f64| (255.0 * (1.0 - (-v * exposure).exp()).powf(1.0 / 2.2)).round();
        let steps = |l: &[[f64; 3]], c: usize| -> Vec<f64> {
            l.windows(2).map(|w| shown(w[1][c]) - shown(w[0][c])).collect()
        };
        (0..3)
            .flat_map(|c| {
                let (got, want) = (steps(self.got, c), steps(self.want, c));
                got.into_iter().zip(want).map(|(g, w)| (g - w).abs()).collect::<Vec<_>>()
            })
            .fold(0.0, f64::max)
    }

    /// Largest error over what the reference has, or over a thousandth of its brightest where that is more.
    pub fn off(&self) -> f64 {
        let floor = 1e-3 * self.brightest();
        let pairs = self.got.iter().flatten().zip(self.want.iter().flatten());
        pairs.map(|(got, want)| (got - want).abs() / want.max(floor)).fold(0.0, f64::max)
    }

    /// Blue, drawn over the reference's.
    pub fn channel(&self) -> Vec<f64> {
        self.got.iter().zip(self.want).map(|(g, w)| g[2] / w[2] - 1.0).collect()
    }
}
