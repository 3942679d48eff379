//! How coefficients are read: every field once, and a message by name where one is not.

use core::fmt;
use core::marker::PhantomData;

use serde_core::Deserialize;
use serde_core::de::{
    DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor,
};

use crate::Scalar;

/// The coefficients of a type with these fields, in their order.
///
/// # Errors
/// The deserialiser's own, and a field that is missing, unknown or there twice, by its name.
pub fn deserialize<'de, D, T, const N: usize>(
    deserializer: D,
    name: &'static str,
    fields: &'static [&'static str; N],
) -> Result<[T; N], D::Error>
where
    D: Deserializer<'de>,
    T: Scalar + Deserialize<'de>,
{
    let coefficients = Coefficients {
        name,
        fields,
        number: PhantomData,
    };
    deserializer.deserialize_struct(name, fields, coefficients)
}

/// Reads all coefficients of a type.
struct Coefficients<T, const N: usize> {
    name: &'static str,
    fields: &'static [&'static str; N],
    number: PhantomData<T>,
}

impl<'de, T, const N: usize> Visitor<'de> for Coefficients<T, N>
where
    T: Scalar + Deserialize<'de>,
{
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "struct {} with {N} coefficients", self.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<[T; N], A::Error> {
        let mut values: [Option<T>; N] = [None; N];
        while let Some(position) = map.next_key_seed(Position(self.fields))? {
            let (Some(value), Some(field)) = (values.get_mut(position), self.fields.get(position))
            else {
                return Err(Error::invalid_length(position, &self));
            };
            if value.is_some() {
                return Err(Error::duplicate_field(field));
            }
            *value = Some(map.next_value()?);
        }
        let mut coefficients = [T::ZERO; N];
        for ((coefficient, value), field) in coefficients.iter_mut().zip(values).zip(self.fields) {
            *coefficient = value.ok_or_else(|| Error::missing_field(field))?;
        }
        Ok(coefficients)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<[T; N], A::Error> {
        let mut coefficients = [T::ZERO; N];
        for (position, coefficient) in coefficients.iter_mut().enumerate() {
            *coefficient = sequence
                .next_element()?
                .ok_or_else(|| Error::invalid_length(position, &self))?;
        }
        Ok(coefficients)
    }
}

/// Reads the name of a field, or its position in formats that write that.
struct Position(&'static [&'static str]);

impl<'de> DeserializeSeed<'de> for Position {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<'de> Visitor<'de> for Position {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a coefficient")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<usize, E> {
        let position = self.0.iter().position(|field| *field == name);
        position.ok_or_else(|| Error::unknown_field(name, self.0))
    }

    fn visit_bytes<E: Error>(self, name: &[u8]) -> Result<usize, E> {
        let position = self.0.iter().position(|field| field.as_bytes() == name);
        position.ok_or_else(|| {
            let unexpected = Unexpected::Bytes(name);
            Error::invalid_value(unexpected, &self)
        })
    }

    fn visit_u64<E: Error>(self, position: u64) -> Result<usize, E> {
        usize::try_from(position)
            .ok()
            .filter(|position| *position < self.0.len())
            .ok_or_else(|| {
                let unexpected = Unexpected::Unsigned(position);
                Error::invalid_value(unexpected, &self)
            })
    }
}
