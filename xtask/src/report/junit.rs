//! Outcomes as JUnit: a suite a source, a test a figure.

use crate::cases::figure::Status;
use crate::cases::run::Outcome;
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// A JUnit report; figures that the copy lost are skipped tests.
///
/// # Errors
/// A text that XML cannot hold.
pub fn render(outcomes: &[Outcome]) -> Result<String, String> {
    let mut report = Report::new("spec cases");
    for outcome in outcomes {
        let mut suite = TestSuite::new(&*outcome.source);
        for figure in &outcome.figures {
            let status = match (&figure.failure, figure.status) {
                (Some(failure), _) => {
                    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
                    let place = format!("{}:{}:{}", figure.file, figure.line, figure.column);
                    status.set_message(format!("{place}: {failure}"));
                    status
                }
                (None, Status::Unrecoverable) => TestCaseStatus::skipped(),
                (None, _) => TestCaseStatus::success(),
            };
            suite.add_test_case(TestCase::new(&*figure.name, status));
        }
        for fault in &outcome.faults {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
            status.set_message(format!("{}:{}:{}: {}", fault.file, fault.line, fault.column, fault.message));
            suite.add_test_case(TestCase::new(format!("{} {}", fault.name, fault.file), status));
        }
        report.add_test_suite(suite);
    }
    report.to_string().map_err(|error| error.to_string())
}
