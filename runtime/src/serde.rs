//! The feature `serde`: records by name, as maps, or in formats without names as sequences.

use core::fmt;
use core::marker::PhantomData;

use serde_core::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_core::ser::{SerializeStruct, Serializer};

use crate::record::Record;

/// Writes a record whose type has this name.
pub fn serialize<S: Serializer, R: Record<N>, const N: usize>(
    record: R,
    name: &'static str,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let mut fields = serializer.serialize_struct(name, N)?;
    for (name, number) in R::NAMES.iter().zip(record.numbers()) {
        fields.serialize_field(name, &number)?;
    }
    fields.end()
}

/// Reads a record whose type has this name: every field once; fields of other names are passed over.
pub fn deserialize<'de, D: Deserializer<'de>, R: Record<N>, const N: usize>(
    name: &'static str,
    deserializer: D,
) -> Result<R, D::Error> {
    deserializer.deserialize_struct(name, R::NAMES, Fields(PhantomData::<R>))
}

/// Reads the fields of a record.
struct Fields<R, const N: usize>(PhantomData<R>);

impl<'de, R: Record<N>, const N: usize> Visitor<'de> for Fields<R, N> {
    type Value = R;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{N} numbers, by name:")?;
        R::NAMES.iter().try_for_each(|name| write!(f, " {name}"))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<R, A::Error> {
        let mut numbers = [0.0; N];
        for (position, number) in numbers.iter_mut().enumerate() {
            *number = sequence.next_element()?.ok_or_else(|| Error::invalid_length(position, &self))?;
        }
        Ok(R::from_numbers(numbers))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<R, A::Error> {
        let mut found = [None; N];
        while let Some(position) = map.next_key_seed(Name(R::NAMES))? {
            match position.and_then(|position| Some((found.get_mut(position)?, R::NAMES.get(position)?))) {
                None => _ = map.next_value::<IgnoredAny>()?,
                Some((Some(_), name)) => return Err(Error::duplicate_field(name)),
                Some((slot, _)) => *slot = Some(map.next_value()?),
            }
        }
        let mut numbers = [0.0; N];
        for ((number, found), name) in numbers.iter_mut().zip(found).zip(R::NAMES) {
            *number = found.ok_or_else(|| Error::missing_field(name))?;
        }
        Ok(R::from_numbers(numbers))
    }
}

/// Reads the name of a field, as its position.
struct Name<'a>(&'a [&'static str]);

impl<'de> DeserializeSeed<'de> for Name<'_> {
    type Value = Option<usize>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<usize>, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Name<'_> {
    type Value = Option<usize>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_u64<E: Error>(self, position: u64) -> Result<Option<usize>, E> {
        Ok(usize::try_from(position).ok().filter(|position| *position < self.0.len()))
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Option<usize>, E> {
        Ok(self.0.iter().position(|known| *known == name))
    }

    fn visit_bytes<E: Error>(self, name: &[u8]) -> Result<Option<usize>, E> {
        Ok(self.0.iter().position(|known| known.as_bytes() == name))
    }
}

/// Makes a record one that serde knows; not for people.
#[doc(hidden)]
#[macro_export]
macro_rules! __serialized {
    ($record:ident, $name:literal, $count:literal) => {
        impl $crate::__private::serde_core::Serialize for $record {
            fn serialize<S: $crate::__private::serde_core::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::__private::serialize::<S, Self, $count>(*self, $name, serializer)
            }
        }

        impl<'de> $crate::__private::serde_core::Deserialize<'de> for $record {
            fn deserialize<D: $crate::__private::serde_core::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::__private::deserialize::<D, Self, $count>($name, deserializer)
            }
        }
    };
}
