//! Requests with the default values of their options.

/// Request whose options have the defaults of the command line; `words` give its required options.
pub(crate) fn defaults<Request: clap::Args>(words: &[&str]) -> Request {
    let line = Request::augment_args(clap::Command::new("request").no_binary_name(true));
    let request = line.try_get_matches_from(words).and_then(|matches| Request::from_arg_matches(&matches));
    request.unwrap_or_else(|error| unreachable!("the words give all required options: {error}"))
}

#[cfg(test)]
mod tests {
    #[test]
    fn each_request_has_its_defaults() {
        let schemes = crate::schemes::request::Request::default();
        let ratio = "6".parse().unwrap();
        let teeth = crate::teeth::request::Request::new(ratio);
        assert_eq!((teeth.ratio, teeth.limit, teeth.checked), (ratio, None, 1));
        let displacement = "250 cm3".parse().unwrap();
        let search = crate::motor::search::request::Request::new(displacement);
        let forms = crate::motor::forms::request::Request::new(displacement);
        assert_eq!((search.places, forms.places, search.goal.torque), (16, 16, None));
        assert_eq!((schemes.scheme, schemes.efficiency.0.value), (None, 0.9702));
    }
}
