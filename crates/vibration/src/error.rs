//! Errors of this crate.

/// An input that describes no vibrating system, or none that the calculation holds for.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A sweep that whoever waits for it ended.
    #[error("the calculation was cancelled")]
    Cancelled,
    /// A quantity that must be finite and above 0.
    #[error("{field} is {value} {unit}; it must be finite and above 0")]
    NotPositive {
        /// Name of the quantity, with the body or spring.
        field: String,
        /// The value given.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
    /// A quantity that must be finite and not below 0.
    #[error("{field} is {value} {unit}; it must be finite and not below 0")]
    Negative {
        /// Name of the quantity, with the body or spring.
        field: String,
        /// The value given.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
    /// A quantity outside its range.
    #[error("{field} is {value} {unit}; it must lie between {low} and {high} {unit}")]
    OutOfRange {
        /// Name of the quantity.
        field: String,
        /// The value given.
        value: f64,
        /// The least allowed.
        low: f64,
        /// The greatest allowed.
        high: f64,
        /// Unit of the values.
        unit: &'static str,
    },
    /// Too few of something.
    #[error("{count} {of}; at least {least} are needed")]
    TooFew {
        /// Things that are counted.
        of: &'static str,
        /// Number given.
        count: usize,
        /// Least number required.
        least: usize,
    },
    /// Two planets at one angle.
    #[error("planets {first} and {second} (from 1) stand at the same angle; each needs its own")]
    SameAngle {
        /// The first planet, from 1.
        first: usize,
        /// The second planet, from 1.
        second: usize,
    },
    /// A body of another model.
    #[error(
        "body {index} is not in the model, which has {count}; take the number that adding a body returned"
    )]
    NoSuchBody {
        /// Index of the body.
        index: usize,
        /// Number of bodies in the model.
        count: usize,
    },
    /// A spring of another model.
    #[error(
        "spring {index} is not in the model, which has {count}; take the number that adding a spring returned"
    )]
    NoSuchSpring {
        /// Index of the spring.
        index: usize,
        /// Number of springs in the model.
        count: usize,
    },
    /// A model in which nothing can move.
    #[error("no body of the model can move; leave at least one coordinate free")]
    NothingMoves,
    /// Matrices of different sizes.
    #[error(
        "the stiffness matrix is {stiffness:?} and the mass matrix {mass:?}; both must be square, of one size"
    )]
    Sizes {
        /// Rows and columns of the stiffness matrix.
        stiffness: [usize; 2],
        /// Rows and columns of the mass matrix.
        mass: [usize; 2],
    },
    /// A matrix element that is no number, or differs from the one across the diagonal.
    #[error(
        "the {matrix} matrix has {value} at ({row}, {column}) and {across} across the diagonal; it must be finite and symmetric"
    )]
    NotSymmetric {
        /// `stiffness` or `mass`.
        matrix: &'static str,
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The element.
        value: f64,
        /// The element across the diagonal.
        across: f64,
    },
    /// A mass matrix that gives some motion no kinetic energy.
    #[error("the mass matrix is not positive definite; every motion must have kinetic energy")]
    MassNotPositive,
    /// A stiffness matrix that gives some motion negative energy.
    #[error("the least eigenvalue is {least} of the largest; the stiffness must be positive semidefinite")]
    StiffnessNegative {
        /// The least `ω²` over the largest.
        least: f64,
    },
    /// The eigenvalue iteration did not end.
    #[error("the eigenvalues of a matrix of {size} rows did not converge in {iterations} iterations")]
    NotConverged {
        /// Rows of the matrix.
        size: usize,
        /// Iterations made.
        iterations: usize,
    },
    /// A speed at which the centripetal terms exceed the stiffness of the system, or of a planet's bearing.
    #[error(
        "at a frame speed of {speed_rad_s} rad/s the centripetal terms exceed the stiffness (what remains is \
         {remaining} of it); the speed must be below the first critical one"
    )]
    AboveCritical {
        /// Speed of the frame, rad/s.
        speed_rad_s: f64,
        /// The least eigenvalue over the largest, or what remains of the stiffness of a planet's bearing over
        /// it.
        remaining: f64,
    },
    /// Planets whose centrifugal forces pull their carrier aside.
    #[error(
        "the centrifugal forces on {carrier} have a resultant of {resultant} of their sum; it must be 0, as the \
         carrier is taken to turn about its centre"
    )]
    Unbalanced {
        /// Name of the carrier.
        carrier: String,
        /// Size of the resultant over the sum of the sizes.
        resultant: f64,
    },
    /// Tooth numbers that form no set of equally spaced planets.
    #[error("teeth {sun} + {ring} over {planets} planets is no integer; equally spaced planets need one")]
    Assembly {
        /// Teeth of the sun.
        sun: u32,
        /// Teeth of the ring.
        ring: u32,
        /// Number of planets.
        planets: u32,
    },
    /// Speeds that contradict the tooth numbers.
    #[error(
        "speeds of sun, ring and carrier {speeds:?} contradict the teeth {sun} and {ring}: \
         z_s·(n_s − n_c) + z_r·(n_r − n_c) = {surplus}; it must be 0"
    )]
    Speeds {
        /// Speeds of sun, ring, carrier over the reference speed.
        speeds: [f64; 3],
        /// Teeth of the sun.
        sun: u32,
        /// Teeth of the ring.
        ring: u32,
        /// Residual of the equation.
        surplus: f64,
    },
    /// Values of one kind where another number of them is needed.
    #[error("{count} values of {of}; {needed} are needed")]
    Count {
        /// Things that are counted.
        of: &'static str,
        /// Number given.
        count: usize,
        /// Number required.
        needed: usize,
    },
}

impl Error {
    /// Name of the fault, which does not change with the message: `not-positive`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}
