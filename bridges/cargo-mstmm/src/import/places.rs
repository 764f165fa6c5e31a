//! Lines and columns of a text.

use super::error::Place;

/// Finds places without counting all lines before each: a file has many elements.
pub struct Places<'a> {
    text: &'a str,
    /// The place of the first character, and of about each one after [`DISTANCE`] bytes.
    marks: Vec<(usize, Place)>,
}

/// The number of bytes between marks.
const DISTANCE: usize = 256;

impl<'a> Places<'a> {
    pub fn of(text: &'a str) -> Self {
        let mut place = Place { line: 1, column: 1 };
        let mut marks = vec![(0, place)];
        let mut next = DISTANCE;
        for (offset, letter) in text.char_indices() {
            if offset >= next {
                marks.push((offset, place));
                next = offset + DISTANCE;
            }
            place = after(place, letter);
        }
        Places { text, marks }
    }

    /// Returns the place at a number of bytes.
    pub fn at(&self, offset: usize) -> Place {
        let index = self.marks.partition_point(|(mark, _)| *mark <= offset);
        let (mark, place) = self.marks[index.saturating_sub(1)];
        self.text.get(mark..offset).unwrap_or_default().chars().fold(place, after)
    }

    /// Returns the place after the last character.
    pub fn end(&self) -> Place {
        self.at(self.text.len())
    }
}

fn after(place: Place, letter: char) -> Place {
    match letter {
        '\n' => Place { line: place.line.saturating_add(1), column: 1 },
        _ => Place { line: place.line, column: place.column.saturating_add(1) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_whole_text() {
        let text = format!("é\r\n\n{}\n{}", "aé\n".repeat(300), "ß<b> ".repeat(300));
        let places = Places::of(&text);
        let mut expected = Place { line: 1, column: 1 };
        for (offset, letter) in text.char_indices() {
            assert_eq!(places.at(offset), expected, "{offset}");
            expected = after(expected, letter);
        }
        assert_eq!(places.end(), expected);
    }
}
