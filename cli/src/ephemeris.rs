//! Sun and moon above a place on Earth at a time, and when the moon's disk meets the sun's.

use glam::DVec3;
use jiff::{Timestamp, tz::TimeZone};
use solar_positioning::delta_t;
use welkin::model::moon::{Disks, MOON_RADIUS, Phase};

use crate::views::Place;

/// Metres in an astronomical unit (IAU 2012).
const AU: f64 = 149_597_870_700.0;
/// Radius of the sun's disk, metres: 959.63″ at 1 au, as eclipse predictions have it (Auwers 1891).
const SUN_RADIUS: f64 = 696.0e6;
/// Radius of the moon from which totality and annularity are told, metres: k = 0.272281, for the valleys of
/// its limb (Espenak & Meeus, Five Millennium Canon of Solar Eclipses, NASA/TP-2006-214141, section 1.4).
const UMBRAL_RADIUS: f64 = 0.272_281 * 6_378_137.0;
/// Metres that light travels in a day.
const LIGHT_DAY: f64 = 299_792_458.0 * 86_400.0;
/// Julian date of the Unix epoch, days.
const UNIX_EPOCH: f64 = 2_440_587.5;
/// Julian date of the epoch J2000.0.
const J2000: f64 = 2_451_545.0;
const DAY: f64 = 86_400.0;

/// Where sun and moon stand as seen from a place: metres towards east, north and up, without refraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bodies {
    /// The sun's middle.
    pub sun: DVec3,
    /// The moon's middle.
    pub moon: DVec3,
}

impl Bodies {
    /// Their disks.
    pub fn disks(&self) -> Disks {
        self.disks_with(MOON_RADIUS)
    }

    /// Magnitude as eclipse predictions give it: of the moon's mean disk while the eclipse is partial, the
    /// ratio of the diameters by the radius of the umbra while it is not.
    pub fn magnitude(&self) -> f64 {
        let umbral = self.disks_with(UMBRAL_RADIUS);
        match umbral.phase() {
            Phase::Annular | Phase::Total => umbral.magnitude(),
            Phase::None | Phase::Partial => self.disks().magnitude().min(1.0),
        }
    }

    fn disks_with(&self, moon_radius: f64) -> Disks {
        Disks {
            sun: (SUN_RADIUS / self.sun.length()).asin(),
            moon: (moon_radius / self.moon.length()).asin(),
            apart: self.sun.cross(self.moon).length().atan2(self.sun.dot(self.moon)),
        }
    }
}

/// Degrees above the horizontal, and from north towards east.
pub fn horizontal(direction: DVec3) -> (f64, f64) {
    let elevation = direction.z.atan2(direction.x.hypot(direction.y)).to_degrees();
    (elevation, direction.x.atan2(direction.y).to_degrees().rem_euclid(360.0))
}

/// Terrestrial time less UTC, seconds. From 1972 on by leap seconds; UT1 counts as UTC, from which it is
/// never 0.9 s off. Before, and after the last leap second that this program knows, what is extrapolated.
pub fn delta_t(time: Timestamp) -> anyhow::Result<f64> {
    let date = time.to_zoned(TimeZone::UTC);
    if date.year() < 1972 {
        return Ok(delta_t::estimate(1970.0 + seconds(time) / (DAY * 365.2425))?);
    }
    let tai = sofars::ts::dat(date.year().into(), date.month().into(), date.day().into(), 0.0);
    Ok(32.184 + tai.map_err(|code| anyhow::anyhow!("no leap seconds for {time} (SOFA's dat: {code})"))?)
}

fn seconds(time: Timestamp) -> f64 {
    time.as_millisecond() as f64 / 1000.0
}

fn dot(rows: [[f64; 3]; 3], v: DVec3) -> DVec3 {
    DVec3::from_array(rows.map(|row| DVec3::from_array(row).dot(v)))
}

/// The moon from the Earth's centre, metres, in the celestial axes (GCRS), by ELP/MPP02; tt: Julian date.
///
/// `stem_branch` turns longitudes to the equinox of date and leaves latitudes on the ecliptic of J2000, 47″ a
/// century off. Its turn is taken back, and the rest done by IAU 2006.
fn moon(tt: f64) -> DVec3 {
    let m = stem_branch::moon_position(tt);
    let t = (tt - J2000) / 36_525.0;
    // General precession in longitude, arc seconds (Capitaine et al. 2003, as in that crate), and nutation.
    let precession = ((-0.000_079_64 * t + 1.105_434_8) * t + 5_028.796_195) * t;
    let (nutation, _) = sofars::pnp::nut00b(tt, 0.0);
    let (sin_lon, cos_lon) = ((m.longitude_degrees - precession / 3600.0).to_radians() - nutation).sin_cos();
    let (sin_lat, cos_lat) = m.latitude_degrees.to_radians().sin_cos();
    let ecliptic = DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat) * (m.distance_km * 1000.0);
    let rows = sofars::coords::ecm06(J2000, 0.0).map(DVec3::from_array);
    rows[0] * ecliptic.x + rows[1] * ecliptic.y + rows[2] * ecliptic.z
}

/// An observer, turning with the Earth; times are seconds of UTC since 1970.
struct Observer {
    /// The place, from the Earth's centre, metres, in the Earth's own axes.
    position: DVec3,
    /// Unit vectors east, north and up of the ellipsoid WGS 84.
    axes: [DVec3; 3],
    delta_t: f64,
}

impl Observer {
    fn new(place: Place, height: f64, delta_t: f64) -> anyhow::Result<Self> {
        let (lon, lat) = (place.longitude.to_radians(), place.latitude.to_radians());
        let position = sofars::coords::gd2gc(sofars::consts::WGS84, lon, lat, height)
            .map_err(|code| anyhow::anyhow!("no such place (SOFA's gd2gc: {code})"))?;
        let [up, north, east] = place.frame();
        Ok(Self { position: position.into(), axes: [east, north, up], delta_t })
    }

    /// Light that arrives together left the sun (8 min) and the moon (1 s) at different times; either is
    /// where it was then as the Earth was then, which is aberration to first order.
    fn see(&self, time: f64) -> anyhow::Result<Bodies> {
        let ut1 = UNIX_EPOCH + time / DAY;
        let tt = ut1 + self.delta_t / DAY;
        let axes = sofars::pnp::pnm06a(tt, 0.0);
        let sun = |tt: f64| {
            let (earth, _) =
                sofars::eph::epv00(tt, 0.0).ok_or_else(|| anyhow::anyhow!("a time outside 1900 to 2100"))?;
            anyhow::Ok(dot(axes, -DVec3::from_array(earth[0]) * AU))
        };
        let moon = |tt: f64| dot(axes, moon(tt));
        let sun = sun(tt - sun(tt)?.length() / LIGHT_DAY)?;
        let moon = moon(tt - moon(tt).length() / LIGHT_DAY);
        let (sin, cos) = sofars::erst::gst06(ut1, 0.0, tt, 0.0, &axes).sin_cos();
        let local = |v: DVec3| {
            let fixed = DVec3::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x, v.z) - self.position;
            DVec3::from_array(self.axes.map(|axis| axis.dot(fixed)))
        };
        Ok(Bodies { sun: local(sun), moon: local(moon) })
    }
}

/// Sun and moon from a place; height above the ellipsoid in metres.
///
/// The sun by SOFA's epv00 (0.02″), the moon by ELP/MPP02 (some 0.1″ as used here), the Earth's axes by IAU
/// 2006/2000A.
///
/// # Errors
/// A time outside 1900 to 2100.
pub fn bodies(time: Timestamp, place: Place, height: f64) -> anyhow::Result<Bodies> {
    Observer::new(place, height, delta_t(time)?)?.see(seconds(time))
}

/// An eclipse as one place sees it, were the Earth transparent. Times to a tenth of a second.
#[derive(Clone, Copy, Debug)]
pub struct Eclipse {
    /// When the disks begin and cease to overlap.
    pub partial: [Timestamp; 2],
    /// When all of the sun or all of the moon begins and ceases to be within the other disk, if it does.
    pub central: Option<[Timestamp; 2]>,
    /// When their middles are closest.
    pub greatest: Timestamp,
    /// Sun and moon then.
    pub bodies: Bodies,
}

/// The eclipse nearest to a time, within 12 hours, or `None`.
///
/// # Errors
/// A time outside 1900 to 2100.
pub fn eclipse(time: Timestamp, place: Place, height: f64) -> anyhow::Result<Option<Eclipse>> {
    let observer = Observer::new(place, height, delta_t(time)?)?;
    let middle = seconds(time);
    let apart = |t: f64| anyhow::Ok(observer.see(middle + t)?.disks().apart);
    // At most one conjunction in a day; the angle falls towards it and rises after.
    let (mut low, mut high) = (-12.0 * 3600.0, 12.0 * 3600.0);
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_a, mut at_b) = (apart(a)?, apart(b)?);
    while high - low > 0.02 {
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - golden * (high - low);
            at_a = apart(a)?;
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + golden * (high - low);
            at_b = apart(b)?;
        }
    }
    let greatest = 0.5 * (low + high);
    let bodies = observer.see(middle + greatest)?;
    if bodies.disks().phase() == Phase::None {
        return Ok(None);
    }
    // The contact between the greatest eclipse and a time when `gap` is above 0.
    let contact = |side: f64, gap: &dyn Fn(&Bodies) -> f64| {
        let (mut inside, mut outside) = (greatest, greatest + side * 3.0 * 3600.0);
        while (outside - inside).abs() > 0.01 {
            let t = 0.5 * (inside + outside);
            if gap(&observer.see(middle + t)?) > 0.0 { outside = t } else { inside = t }
        }
        stamp(middle + 0.5 * (inside + outside))
    };
    let partial = |bodies: &Bodies| {
        let d = bodies.disks();
        d.apart - d.sun - d.moon
    };
    let central = |bodies: &Bodies| {
        let d = bodies.disks_with(UMBRAL_RADIUS);
        d.apart - (d.sun - d.moon).abs()
    };
    let both = |gap: &dyn Fn(&Bodies) -> f64| anyhow::Ok([contact(-1.0, gap)?, contact(1.0, gap)?]);
    let inner = central(&bodies) < 0.0;
    Ok(Some(Eclipse {
        partial: both(&partial)?,
        central: if inner { Some(both(&central)?) } else { None },
        greatest: stamp(middle + greatest)?,
        bodies,
    }))
}

fn stamp(seconds: f64) -> anyhow::Result<Timestamp> {
    Ok(Timestamp::from_millisecond((seconds * 10.0).round() as i64 * 100)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time: &str) -> Timestamp {
        time.parse().unwrap()
    }

    #[test]
    fn the_sun_stands_where_spa_has_it() {
        for (time, latitude, longitude) in [
            ("2024-04-08T18:17:16Z", 25.29, -104.14),
            ("2003-10-17T19:30:30Z", 39.742476, -105.1786),
            ("1975-01-01T03:00:00Z", -33.9, 151.2),
        ] {
            let place = Place { latitude, longitude };
            let (elevation, azimuth) = horizontal(bodies(at(time), place, 0.0).unwrap().sun);
            let spa = crate::sun::position(at(time), place, 0.0).unwrap();
            // SPA promises 3e-4°; ΔT may differ by 5 s, 6e-5°.
            assert!((elevation - spa.elevation).abs() < 4e-4, "{time}: {elevation} {spa:?}");
            assert!(
                ((azimuth - spa.azimuth) * elevation.to_radians().cos()).abs() < 4e-4,
                "{time}: {azimuth} {spa:?}"
            );
        }
    }

    #[test]
    fn leap_seconds_are_counted() {
        for (time, seconds) in [("2024-04-08T18:00:00Z", 69.184), ("1999-06-01T00:00:00Z", 64.184)] {
            assert!((delta_t(at(time)).unwrap() - seconds).abs() < 1e-9);
        }
        // Espenak & Meeus, Five Millennium Canon: 40.2 s at the beginning of 1970.
        assert!((delta_t(at("1970-01-01T00:00:00Z")).unwrap() - 40.2).abs() < 0.3);
        assert!(bodies(at("1600-01-01T00:00:00Z"), Place { latitude: 0.0, longitude: 0.0 }, 0.0).is_err());
    }

    /// Polynomial Besselian elements: rows x, y, d, l1, l2, μ; columns powers of hours from 18h TT. tan f1,
    /// tan f2.
    struct Besselian {
        /// 18h TT in UTC by leap seconds, seconds since 1970.
        begin: f64,
        rows: [[f64; 4]; 6],
        tan: [f64; 2],
    }

    /// From tests/data/besselian.csv.
    fn published(date: &str) -> Besselian {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/besselian.csv");
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
        let rows: Vec<csv::StringRecord> =
            reader.records().map(|r| r.unwrap()).filter(|r| &r[0] == date).collect();
        let row = |name: &str| -> [f64; 4] {
            let row = rows.iter().find(|r| &r[1] == name).unwrap();
            std::array::from_fn(|i| row[2 + i].parse().unwrap())
        };
        Besselian {
            begin: seconds(at(&format!("{date}T18:00:00Z"))) - 69.184,
            rows: ["x", "y", "d", "l1", "l2", "mu"].map(row),
            tan: [row("tan_f1")[0], row("tan_f2")[0]],
        }
    }

    impl Besselian {
        /// Distance from the shadow's axis, and the radii of penumbra and umbra at the observer: Earth radii
        /// (Explanatory Supplement to the Astronomical Almanac, 3rd ed. 2013, section 11.3).
        fn at(&self, place: Place, time: f64) -> [f64; 3] {
            let hours = (time - self.begin) / 3600.0;
            let [x, y, d, l1, l2, mu] =
                self.rows.map(|[a, b, c, d]| a + hours * (b + hours * (c + hours * d)));
            let (lat, flattening) = (place.latitude.to_radians(), 1.0 / 298.257);
            let u = ((1.0 - flattening) * lat.tan()).atan();
            let (rho_sin, rho_cos) = ((1.0 - flattening) * u.sin(), u.cos());
            // The angle of the ephemeris meridian, which lags by 1.002738 ΔT.
            let (sin_h, cos_h) = (mu + place.longitude - 1.002_738 * 69.184 / 240.0).to_radians().sin_cos();
            let (sin_d, cos_d) = d.to_radians().sin_cos();
            let xi = rho_cos * sin_h;
            let eta = rho_sin * cos_d - rho_cos * cos_h * sin_d;
            let zeta = rho_sin * sin_d + rho_cos * cos_h * cos_d;
            [(x - xi).hypot(y - eta), l1 - zeta * self.tan[0], l2 - zeta * self.tan[1]]
        }
    }

    const PLACES: [(&str, f64, f64); 8] = [
        ("2024-04-08", 25.54, -103.41), // Torreón
        ("2024-04-08", 25.29, -104.14), // greatest eclipse
        ("2024-04-08", 19.43, -99.13),  // Mexico City
        ("2024-04-08", 44.76, -69.78),  // Maine, on the path
        ("2023-10-14", 11.37, -83.10),  // greatest eclipse
        ("2023-10-14", 35.08, -106.65), // Albuquerque
        ("2023-10-14", 29.42, -98.49),  // San Antonio
        ("2023-10-14", 40.71, -74.01),  // New York
    ];

    #[test]
    fn local_circumstances_are_those_of_published_elements() {
        for (date, latitude, longitude) in PLACES {
            let place = Place { latitude, longitude };
            let elements = published(date);
            let ours = eclipse(at(&format!("{date}T18:00:00Z")), place, 0.0).unwrap().unwrap();
            // Their greatest eclipse.
            let greatest = seconds(ours.greatest);
            let [m, l1, l2] = elements.at(place, greatest);
            let central = m < l2.abs();
            let theirs = if central { (l1 - l2) / (l1 + l2) } else { (l1 - m) / (l1 + l2) };
            let magnitude = ours.bodies.magnitude();
            println!("{date} {latitude} {longitude}: magnitude {magnitude:.4}, by the elements {theirs:.4}");
            assert_eq!(ours.central.is_some(), central, "{date} {latitude} {longitude}");
            assert!((magnitude - theirs).abs() < 6e-4, "{date} {latitude} {longitude}: {magnitude} {theirs}");
            let later =
                elements.at(place, greatest + 3.0)[0] + elements.at(place, greatest - 3.0)[0] - 2.0 * m;
            let slope = elements.at(place, greatest + 3.0)[0] - elements.at(place, greatest - 3.0)[0];
            // Near the path's middle the distance has a kink there.
            let off = if later > 1e-9 && m > 2e-3 { 3.0 * slope / (2.0 * later) } else { 0.0 };
            assert!(off.abs() < 3.0, "{date} {latitude} {longitude}: greatest {off} s off");
            for (contact, inner) in ours
                .partial
                .map(|t| (t, false))
                .into_iter()
                .chain(ours.central.into_iter().flatten().map(|t| (t, true)))
            {
                let gap = |t: f64| {
                    let [m, l1, l2] = elements.at(place, t);
                    m - if inner { l2.abs() } else { l1 }
                };
                let t = seconds(contact);
                let off = gap(t) / ((gap(t + 1.0) - gap(t - 1.0)) / 2.0);
                println!("    {contact} off by {off:+.2} s");
                assert!(off.abs() < 1.5, "{date} {latitude} {longitude}: {contact} is {off} s off");
            }
        }
    }

    /// Espenak, NASA GSFC: 4 m 28 s and 1.0566 at 25.3° N 104.1° W; 5 m 17 s and 0.9520 at 11.4° N 83.1° W.
    #[test]
    fn greatest_eclipses_are_the_published_ones() {
        for (date, latitude, longitude, magnitude, duration, phase) in [
            ("2024-04-08", 25.3, -104.1, 1.0566, 268.0, Phase::Total),
            ("2023-10-14", 11.4, -83.1, 0.9520, 317.0, Phase::Annular),
        ] {
            let place = Place { latitude, longitude };
            let ours = eclipse(at(&format!("{date}T12:00:00Z")), place, 0.0).unwrap().unwrap();
            assert_eq!(ours.bodies.disks().phase(), phase);
            let [begin, end] = ours.central.unwrap().map(seconds);
            println!("{date}: {:.4}, {:.1} s, {}", ours.bodies.magnitude(), end - begin, ours.greatest);
            assert!((ours.bodies.magnitude() - magnitude).abs() < 6e-4, "{}", ours.bodies.magnitude());
            assert!((end - begin - duration).abs() < 1.5, "{}", end - begin);
        }
        let none =
            eclipse(at("2024-04-01T18:00:00Z"), Place { latitude: 25.3, longitude: -104.1 }, 0.0).unwrap();
        assert!(none.is_none());
        let far =
            eclipse(at("2024-04-08T18:00:00Z"), Place { latitude: -60.0, longitude: -104.1 }, 0.0).unwrap();
        assert!(far.is_none());
    }
}
