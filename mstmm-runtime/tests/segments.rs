//! Pieces of rows, which generated code reads and writes.

use mstmm_runtime::generated::{chunks, chunks_mut, segment};
use mstmm_runtime::nalgebra::SVector;

#[test]
fn pieces_are_those_at_their_place() {
    let array = [0, 1, 2, 3, 4, 5, 6];
    assert_eq!(segment::<_, 2, 1>(&array), [1, 2]);
    assert_eq!(chunks::<_, 2, 1, 3>(&array), [[1, 2], [3, 4], [5, 6]]);
    let vector = SVector::<f64, 4>::new(0.0, 1.0, 2.0, 3.0);
    assert_eq!(segment::<_, 3, 1>(&vector), [1.0, 2.0, 3.0]);
    assert_eq!(chunks::<_, 1, 2, 2>(&vector), [[2.0], [3.0]]);
}

#[test]
fn pieces_are_written_at_their_place() {
    let mut array = [0, 1, 2, 3, 4];
    for [a, b] in chunks_mut::<_, 2, 1, 2>(&mut array) {
        (*a, *b) = (*b, *a);
    }
    assert_eq!(array, [0, 2, 1, 4, 3]);
    let mut vector = SVector::<f64, 2>::zeros();
    chunks_mut::<_, 2, 0, 1>(&mut vector)[0][1] = 1.0;
    assert_eq!(vector.as_slice(), [0.0, 1.0]);
}
