//! Limits in seconds: said by an environment variable, else by `[limits]` of a project's `closedform.toml`, else as usual.

use miette::Diagnostic;
use thiserror::Error;

/// A limit that a project may set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Its key in `[limits]`.
    pub key: &'static str,
    /// The environment variable that comes first.
    pub variable: &'static str,
    /// What holds where nobody says it, in seconds.
    pub usual: u64,
}

/// The processor time of one worksheet in Maxima.
pub const MAXIMA: Limit = Limit { key: "maxima", variable: "CLOSEDFORM_MAXIMA_LIMIT", usual: 120 };

/// The processor time that the algebra may take for one kernel: far more than any known kernel takes.
pub const KERNEL: Limit = Limit { key: "kernel", variable: "CLOSEDFORM_LIMIT", usual: 900 };

/// How long to wait for the turn to use Symbolica: longer than any project of this size takes.
pub const WAIT: Limit = Limit { key: "wait", variable: "CLOSEDFORM_WAIT", usual: 900 };

/// The environment variable is no number.
#[derive(Clone, Debug, PartialEq, Eq, Error, Diagnostic)]
#[error("{} is `{said}`, which is no number of seconds", limit.variable)]
#[diagnostic(help(
    "set it to a whole number of seconds, or unset it: then `{}` in [limits] of closedform.toml holds, or {} s",
    limit.key,
    limit.usual
))]
pub struct LimitError {
    /// Which.
    pub limit: Limit,
    /// What it says.
    pub said: String,
}

impl Limit {
    /// The seconds that hold where the project says these.
    ///
    /// # Errors
    ///
    /// When the environment says something else than a number of seconds.
    pub fn seconds(self, project: Option<u64>) -> Result<u64, LimitError> {
        match std::env::var_os(self.variable) {
            None => Ok(project.unwrap_or(self.usual)),
            Some(text) => {
                let text = text.to_string_lossy();
                text.trim().parse().map_err(|_| LimitError { limit: self, said: text.clone().into_owned() })
            }
        }
    }

    /// How one sets it, for remedies.
    #[must_use]
    pub fn setting(self) -> String {
        format!("`{}` in [limits] of closedform.toml, or the variable {},", self.key, self.variable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nobody_says_is_as_usual() {
        let unheard = Limit { key: "unheard", variable: "CLOSEDFORM_UNHEARD_OF", usual: 7 };
        assert_eq!((unheard.seconds(None), unheard.seconds(Some(3))), (Ok(7), Ok(3)));
    }
}
