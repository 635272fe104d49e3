//! A gearbox by its name: a scheme of the catalogue, or a structure of two sets.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::schemes::answer::{self as answers, SizeName, SizeProblem, Sized};
use crate::shared::gearbox::Origin;
use crate::shared::options::efficiency;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::written;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_schemes::Error as SchemeError;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_schemes::structures::{Renaming, Role, SetRoles, Structure, exchange_brakes, gearbox};
use epicyclic_train::Gearbox;
use epicyclic_units::{Number, Quantity};
use std::path::Path;
use uom::si::f64::Ratio;

/// How large the sets of a scheme or structure are.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub(crate) struct Sizes {
    /// Ring-to-sun ratio k of set 1, of a scheme or structure by its name.
    #[arg(long, allow_hyphen_values = true)]
    k1: Option<Number>,

    /// Ring-to-sun ratio k of set 2.
    #[arg(long, requires = "k1", conflicts_with = "ratio2", allow_hyphen_values = true)]
    k2: Option<Number>,

    /// Ratio of gear 1, in place of --k1.
    #[arg(long, conflicts_with = "k1", allow_hyphen_values = true)]
    ratio1: Option<Number>,

    /// Ratio of gear 2, in place of --k2.
    #[arg(long, allow_hyphen_values = true)]
    ratio2: Option<Number>,
}

impl Sizes {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let all =
            [("--k1", self.k1), ("--k2", self.k2), ("--ratio1", self.ratio1), ("--ratio2", self.ratio2)];
        all.into_iter().find(|(_, size)| size.is_some()).map(|(option, _)| option)
    }

    /// Refuses sizes beside a file, which has its own.
    pub(crate) fn none_with_a_file(&self) -> Result<(), Failure> {
        match self.given() {
            None => Ok(()),
            Some(option) => {
                let message =
                    "it is for schemes and structures by their names; the file says how large its sets are";
                Err(Failure::conflict(option, message))
            }
        }
    }

    fn of_scheme(self) -> answers::Sizes {
        let [k1, k2, ratio1, ratio2] =
            [self.k1, self.k2, self.ratio1, self.ratio2].map(|number| number.map(Number::get));
        answers::Sizes { k1, k2, ratio1, ratio2 }
    }
}

/// Gearbox identified by a name.
enum Named {
    /// A scheme of the catalogue.
    Scheme(Scheme),
    /// Two sets as they are named, and the structure that they are.
    TwoSets([SetRoles; 2], Structure, Renaming),
}

/// Ring-to-sun ratio for calculations that depend on the structure only; not shown.
const ANY_K: f64 = 2.5;

/// Reads a name of a gearbox; `None` if the text is the name of a file.
fn read(call: &Call<'_>, name: &str) -> Result<Option<Named>, Failure> {
    let file = Path::new(name);
    match (name.parse::<Scheme>(), Structure::read(name)) {
        (Ok(scheme), _) => Ok(Some(Named::Scheme(scheme))),
        (_, Ok((structure, renaming))) => {
            let [one, other] = structure.sets();
            let sets = if renaming.sets { [other, one] } else { [one, other] };
            let sets = if renaming.brakes { sets.map(exchange_brakes) } else { sets };
            Ok(Some(Named::TwoSets(sets, structure, renaming)))
        }
        // What looks like a name and is none: say which there are.
        (_, Err(unknown @ SchemeError::NotAStructure { .. })) => Err(unknown.into()),
        (_, Err(unknown)) if name.contains('+') && !call.desk.exists(file) => Err(unknown.into()),
        (Err(unknown), _)
            if file.extension().is_none() && file.components().count() == 1 && !call.desk.exists(file) =>
        {
            Err(unknown.into())
        }
        _ => Ok(None),
    }
}

/// Document of a gearbox, from a file or from a name.
pub(crate) struct Read {
    pub(crate) document: Document,
    /// The text of the document.
    pub(crate) bytes: Vec<u8>,
    /// Whether the sizes in it are known, or some or other.
    pub(crate) is_sized: bool,
    pub(crate) origin: Origin,
}

/// The document of a file, or that of a gearbox by its name, written as a file would be.
pub(crate) fn document(
    call: &Call<'_>,
    name: &str,
    sizes: Sizes,
    eta: Option<Quantity<Ratio>>,
    any_size_will_do: bool,
) -> Result<Read, Failure> {
    let file = Path::new(name);
    let named = if input::exists(call, file) { None } else { read(call, name)? };
    let Some(named) = named else {
        sizes.none_with_a_file()?;
        let (document, bytes) = input::with_bytes(call, file)?;
        return Ok(Read { document, bytes, is_sized: true, origin: Origin::GearboxFile });
    };
    let eta = eta.map_or(Ok(MeshEfficiency::IDEAL), efficiency)?;
    let (gearbox, is_sized) = match named.sized(sizes, eta)? {
        Some(gearbox) => (gearbox, true),
        None if any_size_will_do => (named.of_any_size()?, false),
        None => return Err(named.needs_sizes()),
    };
    let text = written(&gearbox, &[]).unwrap_or_else(|_| unreachable!("schemes have sets of three members"));
    let document = Document::parse_one(name, text.as_bytes())?;
    Ok(Read { document, bytes: text.into_bytes(), is_sized, origin: named.origin() })
}

impl Named {
    /// Where it comes from.
    fn origin(&self) -> Origin {
        match self {
            Self::Scheme(_) => Origin::Catalogue,
            Self::TwoSets(..) => Origin::Structure,
        }
    }

    /// Asks for sizes.
    fn needs_sizes(&self) -> Failure {
        let what_for = "for ratios and speeds";
        let message = match self {
            Self::Scheme(scheme) => format!(
                "{what_for} of {} give --k1 or --ratio1, and of two sets --k2 or --ratio2",
                scheme.name()
            ),
            Self::TwoSets(..) => format!("{what_for} give --k1 and --k2, or --ratio1 and --ratio2"),
        };
        Failure::missing("--k1", message)
    }

    /// The gearbox with these sizes; nothing where none are given.
    fn sized(&self, sizes: Sizes, eta: MeshEfficiency) -> Result<Option<Gearbox>, Failure> {
        let (sets, structure, renaming) = match *self {
            Self::Scheme(scheme) => {
                return Ok(sized(sizes.of_scheme(), scheme, eta)?.map(|found| found.gearbox));
            }
            Self::TwoSets(sets, structure, renaming) => (sets, structure, renaming),
        };
        let refuse = |option, message: &str| Err(Failure::invalid(option, message));
        let answers::Sizes { k1, k2, ratio1, ratio2 } = sizes.of_scheme();
        let k = match ([k1, k2], [ratio1, ratio2]) {
            ([Some(k1), Some(k2)], _) => [k1, k2],
            ([None, None], [Some(first), Some(second)]) => {
                let exchanged =
                    |[one, other]: [f64; 2], is: bool| if is { [other, one] } else { [one, other] };
                let found = structure.ring_to_sun_ratios(exchanged([first, second], renaming.brakes));
                match found {
                    Some(k) => exchanged(k, renaming.sets),
                    None => {
                        return refuse(
                            "--ratio1",
                            "these ratios leave a set without relative motion: no k gives them",
                        );
                    }
                }
            }
            ([None, None], [None, None]) => return Ok(None),
            _ => {
                return refuse(
                    "--k1",
                    "a structure has two sets: give --k1 and --k2, or --ratio1 and --ratio2",
                );
            }
        };
        two_sets(sets, k, eta).map(Some)
    }

    /// The gearbox with some size or other.
    fn of_any_size(&self) -> Result<Gearbox, Failure> {
        match *self {
            Self::Scheme(scheme) => {
                let k2 = matches!(scheme, Scheme::Three(_)).then_some(ANY_K);
                let sizes = answers::Sizes { k1: Some(ANY_K), k2, ..answers::Sizes::default() };
                let found = sized(sizes, scheme, MeshEfficiency::IDEAL)?;
                Ok(found.unwrap_or_else(|| unreachable!("the sizes are given")).gearbox)
            }
            Self::TwoSets(sets, ..) => two_sets(sets, [ANY_K; 2], MeshEfficiency::IDEAL),
        }
    }
}

/// Builds a gearbox of two sets. The direct-drive clutch connects the first two links that leave room for it,
/// input and output tried before others.
fn two_sets(sets: [SetRoles; 2], k: [f64; 2], eta: MeshEfficiency) -> Result<Gearbox, Failure> {
    let name = sets.map(|set| set.map(Role::symbol).join(".")).join("+");
    let with = |clutch| gearbox(&name, &[(sets[0], k[0]), (sets[1], k[1])], eta, Some(clutch));
    let pairs = Role::ALL
        .iter()
        .flat_map(|&one| Role::ALL.map(|other| [one, other]))
        .filter(|[one, other]| one < other);
    let mut any = None;
    for pair in pairs {
        let gearbox = with(pair)?;
        if matches!(draw(&gearbox, Options::default()), Verdict::Drawable(_)) {
            return Ok(gearbox);
        }
        any.get_or_insert(gearbox);
    }
    Ok(any.unwrap_or_else(|| unreachable!("four roles have six pairs")))
}

/// The scheme with the ring-to-sun ratios or ratios that were given, if any were.
fn sized(sizes: answers::Sizes, scheme: Scheme, eta0: MeshEfficiency) -> Result<Option<Sized>, Failure> {
    answers::sized(scheme, sizes, eta0).map_err(refuse_size)
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse_size(error: Error) -> Failure {
    let Error::SchemeSize { size, problem } = error else { return error.into() };
    let option = match size {
        SizeName::K1 => "--k1",
        SizeName::K2 => "--k2",
        SizeName::Ratio1 => "--ratio1",
        SizeName::Ratio2 => "--ratio2",
    };
    let message = match problem {
        SizeProblem::FirstMissing => "give --ratio1 or --k1 too".to_owned(),
        SizeProblem::SecondMissing { scheme } => {
            format!("{scheme} has two sets: give --k2 or --ratio2 too")
        }
        problem => problem.to_string(),
    };
    Failure::invalid(option, message)
}
