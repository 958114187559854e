//! The kick of docs/c.md, with the declarations that bindgen makes of football_physics.h: prints the hash of C#.
#![allow(dead_code, deref_nullptr, non_camel_case_types, non_upper_case_globals)]
include!(concat!(env!("OUT_DIR"), "/football_physics.rs"));

use std::mem::{size_of, zeroed};

fn main() {
    let (position, velocity, spin) = ([0.0, 0.11, 0.0], [3.0, 8.0, -22.0], [0.0, 40.0, 0.0]);
    let sizes = [size_of::<fp_state>() as i32, size_of::<fp_ball>() as i32, size_of::<fp_event>() as i32];
    unsafe {
        let (mut scene, mut state, mut events, mut count) = (std::ptr::null_mut(), zeroed(), zeroed::<[fp_event; 16]>(), 0);
        assert_eq!(fp_check_sizes(FOOTBALL_ABI_VERSION as i32, sizes.as_ptr(), sizes.len() as i32), FP_OK);
        assert_eq!(fp_scene_create(b"{}".as_ptr().cast(), 2, &mut scene), FP_OK);
        assert_eq!(fp_launch(scene, position.as_ptr(), velocity.as_ptr(), spin.as_ptr(), &mut state), FP_OK);
        for _ in 0..120 {
            assert_eq!(fp_step(scene, &mut state, 1.0 / 60.0, events.as_mut_ptr(), 16, &mut count), FP_OK);
            for event in &events[..count as usize] {
                println!("event {} after {:.3} s", event.kind, event.time);
            }
        }
        println!("hash {:016x}", fp_hash(&state));
        assert_eq!(fp_scene_free(scene), FP_OK);
    }
}
