//! Evaluation of a function for many values, in blocks that fill vector registers.

/// The size of a vector register in bytes; zero if there are none.
const REGISTER: usize = if cfg!(target_feature = "avx") {
    32
} else if cfg!(any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")) {
    16
} else {
    0
};

/// The number of values in a block: a loop of this length becomes vector instructions before it is unrolled.
const BLOCK: usize = 8;

/// Returns both results of `one` for all numbers.
///
/// The last block is filled up with zeros if the target has vectors, because a vector instruction costs no more than one
/// for a single number. The result for a number does not depend on its index.
#[inline(always)]
pub(super) fn side_by_side<T: Copy + Default, const N: usize>(
    numbers: [T; N],
    one: impl Fn(T) -> (T, T) + Copy,
) -> ([T; N], [T; N]) {
    let (mut first, mut second) = ([T::default(); N], [T::default(); N]);
    let (blocks, rest) = numbers.as_chunks::<BLOCK>();
    let ((first_blocks, first_rest), (second_blocks, second_rest)) =
        (first.as_chunks_mut::<BLOCK>(), second.as_chunks_mut::<BLOCK>());
    for ((numbers, first), second) in blocks.iter().zip(first_blocks).zip(second_blocks) {
        (*first, *second) = each(*numbers, one);
    }
    let lanes = REGISTER / size_of::<T>();
    match rest.len() {
        0 => {}
        // A shorter loop would be unrolled before it becomes vector instructions. The compiler would then combine pairs,
        // whose loads overlap recent stores.
        2.. if REGISTER == 32 => filled_up::<T, BLOCK>(rest, first_rest, second_rest, one),
        5.. if lanes >= 2 => filled_up::<T, BLOCK>(rest, first_rest, second_rest, one),
        3.. if lanes >= 2 => filled_up::<T, 4>(rest, first_rest, second_rest, one),
        _ => {
            for ((&number, first), second) in rest.iter().zip(first_rest).zip(second_rest) {
                (*first, *second) = one(number);
            }
        }
    }
    (first, second)
}

/// Returns both results for a whole block.
#[inline(always)]
fn each<T: Copy + Default, const N: usize>(
    numbers: [T; N],
    one: impl Fn(T) -> (T, T),
) -> ([T; N], [T; N]) {
    let (mut first, mut second) = ([T::default(); N], [T::default(); N]);
    for ((&number, first), second) in numbers.iter().zip(&mut first).zip(&mut second) {
        (*first, *second) = one(number);
    }
    (first, second)
}

/// Computes both results for up to `N` numbers, filled up with zeros.
#[inline(always)]
fn filled_up<T: Copy + Default, const N: usize>(
    numbers: &[T],
    first: &mut [T],
    second: &mut [T],
    one: impl Fn(T) -> (T, T),
) {
    let mut block = [T::default(); N];
    block.iter_mut().zip(numbers).for_each(|(entry, &number)| *entry = number);
    let (firsts, seconds) = each(block, one);
    first.iter_mut().zip(firsts).for_each(|(entry, result)| *entry = result);
    second.iter_mut().zip(seconds).for_each(|(entry, result)| *entry = result);
}
