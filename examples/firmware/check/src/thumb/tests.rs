//! Tests of the decoder with instructions in assembler notation.

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
    // subw sp, sp, #0x804; str r0, [sp, #-4]!; strd r0, r1, [sp, #-8]!; vpush {s16}; what takes
    // things off again: add sp, #8; addw sp, sp, #0x804; vpop {d8}; str r0, [sp], #4; bx lr
    let prologue = [
        0xb5f0, 0xe92d, 0x0f00, 0xb081, 0xed2d, 0x8b10, 0xf5ad, 0x7d2a, 0xf6ad, 0x0d04, 0xf84d,
        0x0d04, 0xe96d, 0x0102, 0xed2d, 0x8a01, 0xb002, 0xf60d, 0x0d04, 0xecbd, 0x8b02, 0xf84d,
        0x0b04, 0x4770,
    ];
    assert_eq!(read(&prologue).frame, 20 + 16 + 4 + 64 + 0x2a8 + 0x804 + 4 + 8 + 4);
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
fn unknown_effects_are_reported() {
    let unknown = [
        // blx r3; svc #0; tbb [pc, r0]
        &[0x4798][..],
        &[0xdf00],
        &[0xe8df, 0xf000],
        // mov pc, r1; ldr.w pc, [r0]; ldm.w r0, {r1, pc}; pop.w with a number: ldr pc, [sp], #8
        &[0x468f],
        &[0xf8d0, 0xf000],
        &[0xe890, 0x8002],
        &[0xf85d, 0xfb08],
        // mov sp, r7; mov.w sp, r7; sub.w sp, r7, #24; add sp, r4; sub.w sp, sp, r4; ldr.w sp, [r0]
        &[0x46bd],
        &[0xea4f, 0x0d07],
        &[0xf1a7, 0x0d18],
        &[0x44a5],
        &[0xebad, 0x0d04],
        &[0xf8d0, 0xd000],
        // msr msp, r0; msr control, r0
        &[0xf380, 0x8808],
        &[0xf380, 0x8814],
    ];
    for instruction in unknown {
        let function = read(&[instruction, &[0x4770]].concat());
        assert_eq!(function.unknown, BTreeSet::from([0x1000]), "{instruction:x?}");
    }
}

#[test]
fn a_frame_that_grows_in_a_loop_or_code_without_an_end_is_not_passed_over() {
    // again: push {r0}; subs r0, #1; bne again; bx lr
    assert_eq!(read(&[0xb401, 0x3801, 0xd1fc, 0x4770]).unknown, BTreeSet::from([0x1000]));
    // nop; movs r0, #0
    assert_eq!(read(&[0xbf00, 0x2000]).unknown, BTreeSet::from([0x1004]));
    // bx lr; nop, which nothing leads to
    assert_eq!(read(&[0x4770, 0xbf00]).unknown, BTreeSet::new());
    // bl +0x100, which does not come back
    assert_eq!(read(&[0xf000, 0xf87e]).unknown, BTreeSet::new());
}

#[test]
fn data_between_code_is_left_out() {
    // movs r0, #0; b over four bytes; those; bx lr
    let before = code(&[0x2000, 0xe001]);
    let after = code(&[0x4770]);
    let function = function(&[(0x1000, &before), (0x1008, &after)]);
    assert_eq!((function.calls.len(), function.loops), (0, 0));
}
