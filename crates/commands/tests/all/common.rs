//! Designs of stages in series for the tests.

use epicyclic_commands::design::Request;
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::design::answer::trains::TrainOfStages;
use epicyclic_commands::words::request;
use std::ops::ControlFlow;

pub(crate) const GO_ON: fn() -> ControlFlow<()> = || ControlFlow::Continue(());

pub(crate) fn stages(words: &str) -> Stages {
    let request: Request = request(words.split('|')).unwrap();
    request.answer_stages(&GO_ON).unwrap()
}

pub(crate) fn taken(stages: &Stages) -> TrainOfStages {
    let trains = stages.trains.iter().find(|trains| trains.taken);
    trains.unwrap_or_else(|| panic!("{:?}", stages.trains)).best.clone().unwrap()
}
