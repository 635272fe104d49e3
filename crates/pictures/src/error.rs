//! What cannot be drawn.

/// What cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A drawing that no file can hold: a motor of a hundred metres, say.
    #[error(transparent)]
    Drawing(#[from] epicyclic_drawing::Error),
    /// An angle at which a motor is nowhere.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
}
