//! A checker of the part of JSON Schema that our schemas use; it refuses what it does not know, and knows which keys a
//! schema does not describe.

use std::collections::BTreeSet;

use serde_json::{Map, Value};

/// Keywords that say nothing of a value.
const SILENT: [&str; 5] = ["$schema", "title", "description", "default", "definitions"];

/// A schema, what is wrong with a value by it, and what it has met.
pub struct Checker<'a> {
    document: &'a Value,
    /// Places in values that are wrong, with why.
    pub wrong: Vec<String>,
    /// The keys of the schema, by their descriptions' places, that values had.
    pub met: BTreeSet<String>,
}

impl<'a> Checker<'a> {
    pub fn new(document: &'a Value) -> Self {
        Self { document, wrong: Vec::new(), met: BTreeSet::new() }
    }

    /// Checks a value against the whole schema.
    pub fn check(&mut self, value: &Value) {
        self.closed(self.document, "#", value, "");
    }

    /// Checks a value, all keys of which some part of the schema must describe.
    fn closed(&mut self, schema: &'a Value, at: &str, value: &Value, place: &str) {
        let mut known = BTreeSet::new();
        self.open(schema, at, value, place, &mut known);
        for key in value.as_object().into_iter().flat_map(Map::keys).filter(|key| !known.contains(*key)) {
            self.wrong.push(format!("{place}/{key}: unknown"));
        }
    }

    /// Checks a value, and collects which of its keys this part describes.
    fn open(&mut self, schema: &'a Value, at: &str, value: &Value, place: &str, known: &mut BTreeSet<String>) {
        for (keyword, says) in schema.as_object().expect("a schema is an object") {
            let at = format!("{at}/{keyword}");
            match keyword.as_str() {
                "$ref" => {
                    let path = says.as_str().expect("a path").trim_start_matches('#');
                    let target = self.document.pointer(path).expect("what a reference names");
                    self.open(target, &format!("#{path}"), value, place, known);
                }
                "allOf" => {
                    for (position, part) in says.as_array().expect("parts").iter().enumerate() {
                        self.open(part, &format!("{at}/{position}"), value, place, known);
                    }
                }
                "properties" => self.properties(says, &at, value, place, known),
                "additionalProperties" => self.additional(schema, &at, value, place, known),
                "items" => {
                    for (position, item) in value.as_array().into_iter().flatten().enumerate() {
                        self.closed(says, &at, item, &format!("{place}/{position}"));
                    }
                }
                keyword => {
                    if !plain(keyword, says, value) {
                        self.wrong.push(format!("{place}: {keyword} {says}, but is {value}"));
                    }
                }
            }
        }
    }

    fn properties(&mut self, says: &'a Value, at: &str, value: &Value, place: &str, known: &mut BTreeSet<String>) {
        for (key, schema) in says.as_object().expect("schemas by key") {
            if let Some(value) = value.get(key) {
                known.insert(key.clone());
                self.met.insert(format!("{at}/{key}"));
                self.closed(schema, &format!("{at}/{key}"), value, &format!("{place}/{key}"));
            }
        }
    }

    fn additional(&mut self, schema: &'a Value, at: &str, value: &Value, place: &str, known: &mut BTreeSet<String>) {
        let says = &schema["additionalProperties"];
        let named = |key: &str| schema["properties"].get(key).is_some();
        for (key, value) in value.as_object().into_iter().flatten().filter(|(key, _)| !named(key)) {
            if says != &Value::Bool(false) {
                known.insert(key.clone());
                self.closed(says, at, value, &format!("{place}/{key}"));
            }
        }
    }
}

/// Whether a keyword about the value itself holds.
fn plain(keyword: &str, says: &Value, value: &Value) -> bool {
    let length = |value: &Value| value.as_array().map(Vec::len).or(value.as_str().map(str::len));
    let limit = || says.as_u64().expect("a number") as usize;
    match keyword {
        "type" => match says {
            Value::Array(types) => types.iter().any(|one| is(one, value)),
            one => is(one, value),
        },
        "enum" => says.as_array().expect("values").contains(value),
        "required" => value.as_object().is_none_or(|object| {
            says.as_array().expect("keys").iter().all(|key| object.contains_key(key.as_str().expect("a key")))
        }),
        "minItems" | "minLength" => length(value).is_none_or(|length| length >= limit()),
        "maxItems" => length(value).is_none_or(|length| length <= limit()),
        "minimum" => value.as_f64().is_none_or(|value| value >= says.as_f64().expect("a number")),
        keyword => SILENT.contains(&keyword) || panic!("`{keyword}` is not checked by these tests"),
    }
}

fn is(name: &Value, value: &Value) -> bool {
    match name.as_str().expect("the name of a type") {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "null" => value.is_null(),
        name => panic!("`{name}` is no type"),
    }
}

/// The places of all keys that a schema describes.
pub fn keys(schema: &Value, at: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let parts: Vec<(String, &Value)> = match schema {
        Value::Object(parts) => parts.iter().map(|(key, part)| (key.clone(), part)).collect(),
        Value::Array(parts) => parts.iter().enumerate().map(|(at, part)| (at.to_string(), part)).collect(),
        _ => Vec::new(),
    };
    for (key, part) in parts {
        let at = format!("{at}/{key}");
        if key == "properties" {
            found.extend(part.as_object().into_iter().flat_map(Map::keys).map(|key| format!("{at}/{key}")));
        }
        found.extend(keys(part, &at));
    }
    found
}
