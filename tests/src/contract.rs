//! What contracts promise: kernels and the worksheet names of their results.

use toml::{Table, Value};

use crate::worksheets;

/// A kernel as its contract names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contract {
    /// `family::name`.
    pub name: String,
    /// The worksheet names of its results, in order.
    pub worksheets: Vec<String>,
}

/// The contracts of `maxima-ref/FAMILY.toml`.
pub fn load(family: &str) -> Vec<Contract> {
    parse(family, &worksheets::read(family, "toml")).unwrap_or_else(|error| panic!("{family}.toml: {error}"))
}

/// The contracts of a text.
pub fn parse(family: &str, text: &str) -> Result<Vec<Contract>, String> {
    let table: Table = text.parse().map_err(|error: toml::de::Error| error.to_string())?;
    let name = |entry: &Value, key: &str| {
        let found = entry.get(key).and_then(Value::as_str).map(str::to_owned);
        found.ok_or_else(|| format!("an entry without `{key}`: {entry}"))
    };
    let contract = |kernel: &Value| {
        let results = kernel.get("result").map_or(&[][..], array);
        let worksheets = results.iter().map(|result| name(result, "worksheet")).collect::<Result<_, _>>()?;
        Ok(Contract { name: format!("{family}::{}", name(kernel, "name")?), worksheets })
    };
    table.get("kernel").map_or(&[][..], array).iter().map(contract).collect()
}

fn array(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_are_found_with_their_results() {
        let text = "[family]\n[[kernel]]\nname = \"k\"\n[[kernel.result]]\nname = \"r\"\nworksheet = \"f\"\n";
        let contract = Contract { name: "w::k".to_owned(), worksheets: vec!["f".to_owned()] };
        assert_eq!(parse("w", text), Ok(vec![contract]));
        assert!(parse("w", "[[kernel]]\ndoc = \"nameless\"").is_err());
    }
}
