//! Five transmissions in service: layout, teeth, engaged shift elements, published ratios.

#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(clippy::unwrap_used, reason = "fixtures of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::compound::CompoundSpec;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::{GearSpec, Gearbox, GearboxBuilder};

/// A gear with its published ratio.
pub(crate) struct Published {
    pub(crate) gear: &'static str,
    /// Ratio as printed.
    pub(crate) ratio: &'static str,
    /// Published as output over input.
    pub(crate) inverted: bool,
    /// Cut off instead of rounded.
    pub(crate) truncated: bool,
}

pub(crate) struct Machine {
    pub(crate) gearbox: Gearbox,
    pub(crate) gears: Vec<Published>,
}

fn rounded(gear: &'static str, ratio: &'static str) -> Published {
    Published { gear, ratio, inverted: false, truncated: false }
}

fn simple(id: &str, members: [&str; 3], sun: u32, ring: u32) -> SetSpec {
    let eta = MeshEfficiency::new(0.97).unwrap();
    SetSpec::teeth(id, SetKind::Simple, members, sun, ring).unwrap().with_loss(MeshLoss::Set(eta))
}

/// ZF 8HP45: four sets, five shift elements, eight gears and reverse.
pub(crate) fn eight_speed() -> Machine {
    let gears: [(&str, &str, [&str; 3]); 9] = [
        ("1", "4.7143", ["A", "B", "C"]),
        ("2", "3.1429", ["A", "B", "E"]),
        ("3", "2.1064", ["B", "C", "E"]),
        ("4", "1.6667", ["B", "D", "E"]),
        ("5", "1.2854", ["B", "C", "D"]),
        ("6", "1.0000", ["C", "D", "E"]),
        ("7", "0.8387", ["A", "C", "D"]),
        ("8", "0.6667", ["A", "D", "E"]),
        ("R", "-3.295", ["A", "B", "D"]),
    ];
    let mut builder = Gearbox::builder("ZF 8HP45")
        .links(["in", "S1S2", "R1", "C1R4", "R2S3", "R3S4", "C3", "out"])
        .set(simple("P1", ["S1S2", "R1", "C1R4"], 48, 96))
        .set(simple("P2", ["S1S2", "R2S3", "in"], 48, 96))
        .set(simple("P3", ["R2S3", "R3S4", "C3"], 60, 96))
        .set(simple("P4", ["R3S4", "C1R4", "out"], 28, 104))
        .brake("A", "S1S2")
        .brake("B", "R1")
        .clutch("C", "in", "R3S4")
        .clutch("D", "C3", "out")
        .clutch("E", "R2S3", "R3S4")
        .input("in")
        .output("out");
    for (name, _, engaged) in gears {
        builder = builder.gear(name, engaged);
    }
    let gears = gears.map(|(name, ratio, _)| rounded(name, ratio)).into();
    Machine { gearbox: builder.build().unwrap(), gears }
}

/// GM TH400: a Simpson set.
pub(crate) fn simpson() -> Machine {
    let gearbox = Gearbox::builder("GM TH400")
        .links(["in", "RA", "S", "CB", "out"])
        .set(simple("PA", ["S", "RA", "out"], 26, 54))
        .set(simple("PB", ["S", "out", "CB"], 26, 54))
        .clutch("FWD", "in", "RA")
        .clutch("DIR", "in", "S")
        .brake("INT", "S")
        .brake("LR", "CB")
        .input("in")
        .output("out")
        .gear("1", ["FWD", "LR"])
        .gear("2", ["FWD", "INT"])
        .gear("3", ["FWD", "DIR"])
        .gear("R", ["DIR", "LR"])
        .build()
        .unwrap();
    let gears = vec![rounded("1", "2.48"), rounded("2", "1.48"), rounded("3", "1.00"), rounded("R", "-2.08")];
    Machine { gearbox, gears }
}

/// Ford AOD: a Ravigneaux set, with the efficiencies of its meshes at the small sun, between the planets, at
/// the large sun and at the ring.
pub(crate) fn ravigneaux_set(etas: [f64; 4]) -> GearboxBuilder {
    let [small, between, large, ring] = etas.map(|eta| MeshEfficiency::new(eta).unwrap());
    let set = CompoundSpec::new("RAV", "C")
        .sun("Ss", 30)
        .sun("Sl", 36)
        .ring("out", 72)
        .planet("short", &[18])
        .planet("long", &[18])
        .mesh("Ss", "short", small)
        .mesh("short", "long", between)
        .mesh("Sl", "long", large)
        .mesh("long", "out", ring);
    aod(Gearbox::builder("Ford AOD").links(["in", "Ss", "Sl", "C", "out"]).compound_set(set))
}

/// Ford AOD as two independent sets instead of a Ravigneaux set.
pub(crate) fn ravigneaux_builder(losses: [MeshLoss; 2]) -> GearboxBuilder {
    let double = SetSpec::teeth("RAVb", SetKind::DoublePlanet, ["Ss", "out", "C"], 30, 72).unwrap();
    aod(Gearbox::builder("Ford AOD")
        .links(["in", "Ss", "Sl", "C", "out"])
        .set(double.with_loss(losses[0]))
        .set(simple("RAVa", ["Sl", "out", "C"], 36, 72).with_loss(losses[1])))
}

/// Adds shift elements and gears of the Ford AOD.
fn aod(sets: GearboxBuilder) -> GearboxBuilder {
    sets.clutch("FWD", "in", "Ss")
        .clutch("REV", "in", "Sl")
        .clutch("DIR", "in", "C")
        .brake("B2", "Sl")
        .brake("LR", "C")
        .input("in")
        .output("out")
        .gear("1", ["FWD", "LR"])
        .gear("2", ["FWD", "B2"])
        .gear("3", ["FWD", "DIR"])
        .gear("4", ["DIR", "B2"])
        .gear("R", ["REV", "LR"])
}

/// Ford AOD.
pub(crate) fn ravigneaux() -> Machine {
    let gearbox = ravigneaux_builder([MeshLoss::IDEAL; 2]).build().unwrap();
    let gears = vec![
        rounded("1", "2.40"),
        rounded("2", "1.47"),
        rounded("3", "1.00"),
        rounded("4", "0.67"),
        rounded("R", "-2.00"),
    ];
    Machine { gearbox, gears }
}

fn special(name: &str, engaged: &str, input: Option<&str>, output: Option<&str>) -> GearSpec {
    GearSpec {
        name: name.into(),
        engaged: engaged.split_whitespace().map(Into::into).collect(),
        input: input.map(Into::into),
        output: output.map(Into::into),
    }
}

/// Toyota Prius P410: power split, motor reduction, two pairs, a grounded carrier.
pub(crate) fn power_split() -> Machine {
    let gearbox = Gearbox::builder("Toyota Prius P410")
        .links(["eng", "mg1", "mg2", "ring", "cs", "diff", "C2"])
        .set(simple("PSD", ["mg1", "ring", "eng"], 30, 78))
        .set(simple("MSR", ["mg2", "ring", "C2"], 22, 58))
        .set(SetSpec::pair("CG", ["ring", "cs"], 54, 55).unwrap())
        .set(SetSpec::pair("FG", ["cs", "diff"], 24, 77).unwrap())
        .ground("C2")
        .brake("LOCK_ENG", "eng")
        .brake("LOCK_MG1", "mg1")
        .clutch("TIE", "eng", "mg1")
        .input("eng")
        .output("ring")
        .gear_spec(special("MG1 locked", "LOCK_MG1", None, None))
        .gear_spec(special("EV", "LOCK_ENG", Some("mg1"), None))
        .gear_spec(special("MG2", "LOCK_ENG", Some("mg2"), None))
        .gear_spec(special("final drive", "LOCK_ENG", Some("ring"), Some("diff")))
        .gear_spec(special("all tied", "TIE", None, None))
        .build()
        .unwrap();
    let gears = vec![
        rounded("MG1 locked", "0.7222"),
        rounded("EV", "-2.6"),
        rounded("MG2", "-2.636"),
        Published { truncated: true, ..rounded("final drive", "3.267") },
        rounded("all tied", "1.000"),
    ];
    Machine { gearbox, gears }
}

/// NREL GRC 750 kW: a planetary stage and two pairs, speeding up; nothing to engage.
pub(crate) fn wind() -> Machine {
    let gearbox = Gearbox::builder("NREL GRC 750 kW")
        .links(["in", "R1", "s", "i", "out"])
        .set(simple("P1", ["s", "R1", "in"], 21, 99))
        .set(SetSpec::pair("G2", ["s", "i"], 82, 23).unwrap())
        .set(SetSpec::pair("G3", ["i", "out"], 88, 22).unwrap())
        .ground("R1")
        .input("in")
        .output("out")
        .gear_spec(special("overall", "", None, None))
        .gear_spec(special("planetary stage", "", None, Some("s")))
        .build()
        .unwrap();
    let inverted = |gear, ratio| Published { inverted: true, ..rounded(gear, ratio) };
    Machine { gearbox, gears: vec![inverted("overall", "81.491"), inverted("planetary stage", "5.714")] }
}

pub(crate) fn all() -> Vec<Machine> {
    vec![eight_speed(), simpson(), ravigneaux(), power_split(), wind()]
}
