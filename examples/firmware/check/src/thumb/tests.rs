//! Instructions as the manual and assemblers write them.

use super::*;

fn code(halfwords: &[u16]) -> Vec<u8> {
    halfwords.iter().flat_map(|half| half.to_le_bytes()).collect()
}

fn read(halfwords: &[u16]) -> Function {
    function(&[(0x1000, &code(halfwords))])
}

#[test]
fn frames_add_up() {
    // push {r4-r7, lr}; push.w {r8-r11}; sub sp, #4; vpush {d8-d15}; sub.w sp, sp, #0x2a8;
    // subw sp, sp, #0x804; str r0, [sp, #-4]!; strd r0, r1, [sp, #-8]!; bx lr
    let prologue = [
        0xb5f0, 0xe92d, 0x0f00, 0xb081, 0xed2d, 0x8b10, 0xf5ad, 0x7d2a, 0xf6ad, 0x0d04, 0xf84d,
        0x0d04, 0xe96d, 0x0102, 0x4770,
    ];
    assert_eq!(read(&prologue).frame, 20 + 16 + 4 + 64 + 0x2a8 + 0x804 + 4 + 8);
}

#[test]
fn calls_are_found() {
    // bl +0x100; b.w -0x800; bx lr
    let function = read(&[0xf000, 0xf87e, 0xf7ff, 0xbbfe, 0x4770]);
    assert_eq!(function.calls, BTreeSet::from([0x1000 + 0x100, 0x1004 - 0x800]));
    assert_eq!((function.loops, function.unknown.len()), (0, 0));
}

#[test]
fn a_loop_is_seen_and_a_jump_back_that_is_none_is_not() {
    // again: subs r0, #1; bne again; bx lr
    assert_eq!(read(&[0x3801, 0xd1fd, 0x4770]).loops, 1);
    // again: subs r0, #1; bne.w again; bx lr
    assert_eq!(read(&[0x3801, 0xf47f, 0xaffd, 0x4770]).loops, 1);
    // cbz r0, far; back: bx lr; far: movs r0, #1; b back
    assert_eq!(read(&[0xb100, 0x4770, 0x2001, 0xe7fc]).loops, 0);
    // it ne; bxne lr; subs r0, #1; b to the start
    assert_eq!(read(&[0xbf18, 0x4770, 0x3801, 0xe7fb]).loops, 1);
}

#[test]
fn what_hangs_on_a_number_is_not_passed_over() {
    // blx r3; mov pc, r1; sub.w sp, sp, r4; tbb [pc, r0]
    let unknown = [&[0x4798][..], &[0x468f], &[0xebad, 0x0d04], &[0xe8df, 0xf000]];
    for instruction in unknown {
        assert_eq!(read(instruction).unknown, [0x1000], "{instruction:x?}");
    }
}

#[test]
fn data_between_code_is_left_out() {
    // movs r0, #0; b over four bytes; those; bx lr
    let before = code(&[0x2000, 0xe001]);
    let after = code(&[0x4770]);
    let function = function(&[(0x1000, &before), (0x1008, &after)]);
    assert_eq!((function.calls.len(), function.loops), (0, 0));
}
