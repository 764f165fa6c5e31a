//! States, inputs and parameters as maps from names to numbers, by `serde`.

use core::fmt;
use core::marker::PhantomData;

use serde_core::de::{self, DeserializeSeed, Deserializer, MapAccess, Visitor};
use serde_core::ser::{SerializeMap, Serializer};
use serde_core::{Deserialize, Serialize};

use super::labels::{Label, Labels};
use super::listing::Listing;
use crate::{ChainState, Described, Scalar};

impl<T: Serialize, const N: usize> Serialize for Listing<T, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut map = serializer.serialize_map(Some(N))?;
        for (label, value, _) in self.entries() {
            map.serialize_entry(&label, value)?;
        }
        map.end()
    }
}

impl Serialize for Label {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        serializer.collect_str(self)
    }
}

/// Reads a state from a map.
///
/// # Errors
/// Names that are unknown, missing or repeated; values that are not numbers.
pub fn read_state<'de, C, D, const N: usize>(deserializer: D) -> Result<C::State, D::Error>
where
    C: Described<Scalar: Deserialize<'de>>,
    D: Deserializer<'de>,
{
    let values = read::<C::Scalar, D, N>(Labels::of_state(C::DESCRIPTION), deserializer)?;
    let mut state = C::State::zero_position();
    let mut values = values.into_iter();
    for place in state.coordinates_mut() {
        *place = values.next().unwrap_or_default();
    }
    for place in state.rates_mut() {
        *place = values.next().unwrap_or_default();
    }
    state.set_time(values.next().unwrap_or_default());
    Ok(state)
}

/// Reads inputs from a map.
///
/// # Errors
/// As [`read_state`].
pub fn read_inputs<'de, C, D, const N: usize>(deserializer: D) -> Result<C::Inputs, D::Error>
where
    C: Described<Scalar: Deserialize<'de>>,
    D: Deserializer<'de>,
{
    let values = read::<C::Scalar, D, N>(Labels::of_inputs(C::DESCRIPTION), deserializer)?;
    C::inputs_from_slice(&values).ok_or_else(|| de::Error::invalid_length(N, &"all inputs"))
}

/// Reads a chain from a map of its parameters.
///
/// A value can be valid only together with other values. So refused values are set again after the others, until all
/// are set or no other one can be.
///
/// # Errors
/// As [`read_state`], and the error of the setter for values that are refused.
pub fn read_parameters<'de, C, D, const N: usize>(deserializer: D) -> Result<C, D::Error>
where
    C: Described<Scalar: Deserialize<'de>> + Default,
    D: Deserializer<'de>,
{
    let values = read::<C::Scalar, D, N>(Labels::of_parameters(C::DESCRIPTION), deserializer)?;
    let (mut chain, mut is_set) = (C::default(), [false; N]);
    loop {
        let (mut refused, mut has_changed) = (None, false);
        for (index, (value, is_set)) in values.iter().zip(&mut is_set).enumerate() {
            if *is_set {
                continue;
            }
            match chain.set_parameter(index, *value) {
                Ok(()) => (*is_set, has_changed) = (true, true),
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        match refused {
            None => return Ok(chain),
            Some(error) if !has_changed => return Err(de::Error::custom(error)),
            Some(_) => {}
        }
    }
}

fn read<'de, T, D, const N: usize>(labels: Labels, deserializer: D) -> Result<[T; N], D::Error>
where
    T: Scalar + Deserialize<'de>,
    D: Deserializer<'de>,
{
    deserializer.deserialize_map(Values { labels, scalar: PhantomData })
}

/// Reads all values of a map.
struct Values<T, const N: usize> {
    labels: Labels,
    scalar: PhantomData<T>,
}

impl<'de, T: Scalar + Deserialize<'de>, const N: usize> Visitor<'de> for Values<T, N> {
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [_, all] = self.labels.what();
        write!(f, "a map from the names of all {all} of `{}` to numbers", self.labels.chain())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<[T; N], A::Error> {
        let (mut values, mut has) = ([T::default(); N], [false; N]);
        while let Some(index) = map.next_key_seed(Index(self.labels))? {
            let (Some(value), Some(has)) = (values.get_mut(index), has.get_mut(index)) else {
                return Err(de::Error::invalid_length(index, &self));
            };
            if *has {
                return Err(self.error(index, "is given twice"));
            }
            (*value, *has) = (map.next_value()?, true);
        }
        match has.iter().position(|has| !has) {
            Some(index) => Err(self.error(index, "is missing")),
            None => Ok(values),
        }
    }
}

impl<T, const N: usize> Values<T, N> {
    /// Returns the error that a condition holds for a value.
    fn error<E: de::Error>(&self, index: usize, condition: &str) -> E {
        match self.labels.iter().nth(index) {
            Some((label, _)) => E::custom(format_args!("`{label}` {condition}")),
            None => E::invalid_length(index, &"an index of a value"),
        }
    }
}

/// Reads a name and returns its index.
struct Index(Labels);

impl<'de> DeserializeSeed<'de> for Index {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl Visitor<'_> for Index {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [one, _] = self.0.what();
        write!(f, "the name of {one} of `{}`", self.0.chain())
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<usize, E> {
        let ([one, _], chain) = (self.0.what(), self.0.chain());
        let unknown = || E::custom(format_args!("`{name}` is not the name of {one} of `{chain}`"));
        self.0.index(name).ok_or_else(unknown)
    }
}
