//! Requests of the setting `answers`.

use super::route::readable_routes;
use crate::diag::Diagnostics;
use crate::model::lower::Draft;
use crate::model::{ANSWER_WORDS, Request};

/// Reports requests that a chain cannot answer because it is closed.
pub(super) fn requests_fit_closed_chains(draft: &Draft, diagnostics: &mut Diagnostics) {
    let Some(route) = readable_routes(draft).next() else { return };
    let is_closed = match &route.route.items[..] {
        [first, .., last] => [first, last].iter().all(|&&item| draft.items[item].is_end()),
        _ => false,
    };
    for request in draft.settings.requests.iter().filter(|_| is_closed) {
        if is_for_open_chains(request.value) {
            let word = word_of(request.value);
            let message = format!(
                "a chain that is held at both ends has no `{word}` yet: remove the word, or leave one end free; its \
                 derivatives are those by `Dual` numbers as scalars, and its answers are `{CLOSED}`"
            );
            diagnostics.error_over(request.at, message);
        }
    }
}

/// The answers of a closed chain, for a message.
const CLOSED: &str = "[basic, momentum, regressor, coriolis_matrix]";

fn is_for_open_chains(request: Request) -> bool {
    match request {
        Request::Derivatives | Request::Linearize | Request::Push | Request::Pull => true,
        Request::InverseDynamics
        | Request::BiasEfforts
        | Request::MassMatrix
        | Request::CoriolisMatrix
        | Request::Kinematics
        | Request::Jacobian
        | Request::Momentum
        | Request::Regressor => false,
    }
}

/// Returns the word for a single request.
fn word_of(request: Request) -> &'static str {
    let found = ANSWER_WORDS.iter().find(|(_, requests)| *requests == [request]);
    found.map_or_else(|| bug!("no word asks for {request:?}"), |(word, _)| word)
}
