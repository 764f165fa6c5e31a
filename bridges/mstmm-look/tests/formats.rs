//! Files that are read back.

#[path = "../examples/gallery/chains.rs"]
mod chains;
#[path = "../examples/gallery/motions.rs"]
mod motions;

use chains::Dog;
use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Described, Error};
use mstmm_look::{Group, Motion, Options, Recording};
use std::io::Read;
use std::path::PathBuf;

/// A folder that is removed at the end of a test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("mstmm-look-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a folder");
        Folder(path)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Values are those of the accessors of states and workspaces.
#[test]
fn recordings_have_what_accessors_return() -> Result<(), Error> {
    let dog = Dog::<f64>::new();
    let (mut state, inputs, mut at) = (dog.initial_state(), dog.no_inputs(), dog.workspace());
    let mut rk4 = Rk4::new(1e-3);
    let mut recording = Recording::with(&dog, Options::default().stride(5).with(Group::Velocities));
    for step in 0..11 {
        recording.record(&state, &inputs)?;
        if step == 10 {
            dog.solve_into(&state, &inputs, &mut at)?;
        }
        rk4.step(&dog, &mut state, |_, _| inputs)?;
    }
    assert_eq!(recording.len(), 3, "states 0, 5 and 10");
    let row = recording.last().expect("a frame");
    let value = |name: &str| row[recording.column(name).expect(name)];
    assert!((value("time") - 0.01).abs() < 1e-15);
    let (knee, thigh) = (at.fl_knee(), at.fl_thigh());
    assert_eq!(value("fl.knee.acceleration"), knee.acceleration());
    assert_eq!(value("fl.knee.effort"), knee.effort());
    assert_eq!(value("fl.thigh.output.force.z"), thigh.output().force().z);
    assert_eq!(value("fl.thigh.input.moment.x"), thigh.input().moment().x);
    assert_eq!(value("fl.thigh.input.position.y"), thigh.input().position().y);
    assert_eq!(value("fl.thigh.input.velocity.y"), thigh.input().velocity().y);
    assert_eq!(value("harness.tension"), at.harness().tension());
    assert_eq!(value("kinetic_energy"), at.kinetic_energy());
    // The rotation of the recorded quaternion is that of the point, up to a few roundings.
    let unit = ["w", "x", "y", "z"].map(|it| value(&format!("fl.thigh.input.orientation.{it}")));
    let [w, x, y, z] = unit;
    let matrix = thigh.input().orientation();
    let expected = [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)];
    for (row, entry) in expected.iter().enumerate() {
        assert!((matrix[(row, 0)] - entry).abs() < 8.0 * f64::EPSILON);
    }
    // Units are those of the description.
    let columns = recording.columns();
    for quantity in Dog::<f64>::DESCRIPTION.rates().iter() {
        let index = recording.column(&quantity.name.to_string()).expect("a column");
        assert_eq!(columns[index].unit, quantity.unit);
    }
    Ok(())
}

/// Quaternions of a body that turns several times change steadily.
#[test]
fn quaternions_do_not_jump() -> Result<(), Error> {
    let motion = motions::tree(600)?;
    let first = motion.block("orientation").expect("orientations").first;
    let rows: Vec<&[f64]> = motion.rows().collect();
    for pair in rows.windows(2) {
        let product: f64 = (first..first + 4).map(|k| pair[0][k] * pair[1][k]).sum();
        assert!(product > 0.9);
    }
    Ok(())
}

#[test]
fn csv_reads_back_to_the_same_bits() -> Result<(), Box<dyn std::error::Error>> {
    let (motion, folder) = (motions::crane()?, Folder::new("csv"));
    motion.write_csv(folder.path("crane.csv"))?;
    let text = std::fs::read_to_string(folder.path("crane.csv"))?;
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().expect("a head").split(',').collect();
    assert_eq!(head[..3], ["time [s]", "foot.angle [rad]", "knuckle.angle [rad]"]);
    assert!(head.contains(&"jib.input.force.x [N]") && head.contains(&"jib.input.moment.z [N*m]"));
    let mut count = 0;
    for (line, row) in lines.zip(motion.rows()) {
        let read: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let bits = |values: &[f64]| values.iter().map(|it| it.to_bits()).collect::<Vec<u64>>();
        assert_eq!(bits(&read?), bits(row));
        count += 1;
    }
    assert_eq!(count, motion.len());
    Ok(())
}

/// Returns the head of an array as text, and its bytes.
fn array(path: &std::path::Path, name: &str) -> (String, Vec<u8>) {
    let mut archive =
        zip::ZipArchive::new(std::fs::File::open(path).expect("a file")).expect("zip");
    let mut bytes = Vec::new();
    let mut file = archive.by_name(&format!("{name}.npy")).expect(name);
    file.read_to_end(&mut bytes).expect("an array");
    assert_eq!(bytes[..8], *b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0);
    (
        String::from_utf8(bytes[10..10 + length].to_vec()).expect("a head"),
        bytes[10 + length..].to_vec(),
    )
}

#[test]
fn npz_reads_back_to_the_same_bits() -> Result<(), Box<dyn std::error::Error>> {
    let (motion, folder) = (motions::dog()?, Folder::new("npz"));
    let path = folder.path("dog.npz");
    motion.write_npz(&path)?;
    let points = motion.mechanism().points.len();
    for block in motion.blocks() {
        let (head, bytes) = array(&path, block.name);
        assert!(head.contains("'descr': '<f8', 'fortran_order': False"), "{head}");
        let lengths: Vec<usize> =
            std::iter::once(motion.len()).chain(block.shape.iter().copied()).collect();
        let shape = lengths.iter().map(|it| format!("{it}, ")).collect::<String>();
        assert!(head.contains(&format!("'shape': ({})", shape.trim_end())), "{head}");
        let columns = block.first..block.first + block.width();
        let expected = motion.rows().flat_map(|row| &row[columns.clone()]).map(|it| it.to_bits());
        let read = bytes.chunks_exact(8).map(|it| u64::from_le_bytes(it.try_into().expect("8")));
        assert!(read.eq(expected), "{}", block.name);
    }
    assert_eq!(motion.block("force").expect("forces").shape, [points, 3]);
    let (head, bytes) = array(&path, "point_names");
    let longest = motion.mechanism().points.iter().map(|it| it.name.len()).max().expect("a point");
    assert!(head.contains(&format!("'descr': '<U{longest}'")), "{head}");
    assert_eq!(bytes.len(), 4 * longest * points);
    numpy_reads(&motion, &path);
    Ok(())
}

/// Numpy reads the same numbers, where it is installed.
fn numpy_reads(motion: &Motion, path: &std::path::Path) {
    let program = "import numpy, sys; d = numpy.load(sys.argv[1]); f = d['force']; \
                   print(*f.shape, f[-1].sum().hex(), d['point_names'][1], d['coordinates_units'][0])";
    let found = std::process::Command::new("python3").args(["-c", program]).arg(path).output();
    let Some(found) = found.ok().filter(|it| it.status.success()) else {
        println!("skipped: python3 with numpy is not available");
        return;
    };
    let text = String::from_utf8(found.stdout).expect("text");
    let words: Vec<&str> = text.split_whitespace().collect();
    let points = motion.mechanism().points.len();
    assert_eq!(words[..3], [motion.len().to_string(), points.to_string(), "3".to_owned()]);
    assert_eq!(words[4], motion.mechanism().points[1].name);
    assert_eq!(words[5], "m");
}

#[test]
fn pages_of_large_trees_are_below_ten_megabytes() -> Result<(), Box<dyn std::error::Error>> {
    let motion = motions::tree(10_000)?;
    assert_eq!((motion.mechanism().bodies.len(), motion.len()), (50, 10_000));
    let page = motion.html(&Default::default())?;
    println!("{} bytes", page.len());
    assert!(page.len() < 10_000_000, "{} bytes", page.len());
    assert!(!page.contains("http://") && !page.contains("https://"), "a page needs no network");
    Ok(())
}

#[test]
fn what_cannot_be_shown_is_an_error() -> Result<(), Box<dyn std::error::Error>> {
    let dog = Dog::<f64>::new();
    let empty = Recording::new(&dog);
    let message = empty.html(&Default::default()).expect_err("no frames").to_string();
    assert!(message.contains("no frames"), "{message}");
    assert!(empty.svg(0).expect_err("no frames").to_string().contains("0 frames"));
    let mut blind = Recording::with(&dog, Options::default().without(Group::Poses));
    blind.record(&dog.initial_state(), &dog.no_inputs())?;
    assert!(
        blind.html(&Default::default()).expect_err("no poses").to_string().contains("no poses")
    );
    let mut state = dog.initial_state();
    state.v[0] = f64::NAN;
    let mut recording = Recording::new(&dog);
    assert_eq!(recording.record(&state, &dog.no_inputs()), Err(Error::NotFinite(Origin::Rate(0))));
    assert!(recording.is_empty());
    let mut motion = Motion::of(&dog, Options::default());
    assert!(motion.push(&[0.0]).expect_err("too few").to_string().contains("not 1"));
    motion.push(&vec![f64::NAN; motion.columns().len()])?;
    assert!(
        motion.html(&Default::default()).expect_err("not finite").to_string().contains("`time`")
    );
    assert!(motion.svg(0).is_err());
    Ok(())
}

/// A motion of `f32` is recorded, and rows that are pushed make the same page.
#[test]
fn pushed_rows_make_the_same_page() -> Result<(), Box<dyn std::error::Error>> {
    let dog = Dog::<f32>::new();
    let mut recording = Recording::new(&dog);
    recording.record(&dog.initial_state(), &dog.no_inputs())?;
    let mut motion = Motion::of(&dog, Options::default());
    recording.rows().try_for_each(|row| motion.push(row))?;
    assert_eq!(motion.html(&Default::default())?, recording.html(&Default::default())?);
    assert_eq!(motion.svg(0)?, recording.svg(0)?);
    Ok(())
}

/// The text of a description cannot end the data of a page.
#[test]
fn texts_are_escaped() -> Result<(), Box<dyn std::error::Error>> {
    let mut motion = motions::crane()?;
    let wrong = "</script><script>alert(1)</script>";
    motion.mechanism_mut().docs = wrong.to_owned();
    let options = mstmm_look::PageOptions::default().title("a < b & c");
    let page = motion.html(&options)?;
    assert!(!page.contains("<script>alert") && page.contains("\\u003c/script>"));
    assert!(page.contains("<title>a &lt; b &amp; c</title>"));
    Ok(())
}

/// A mechanism has its springs and axes; a picture has a zig-zag of fifteen lines for each spring.
#[test]
fn springs_and_axes_are_known() -> Result<(), Box<dyn std::error::Error>> {
    let motion = motions::dog()?;
    let mechanism = motion.mechanism();
    let [harness] = &mechanism.springs[..] else { panic!("{:?}", mechanism.springs) };
    let trunk = mechanism.bodies.iter().position(|body| body.name == "trunk");
    assert_eq!(
        (harness.name.as_str(), harness.ends[0].body, harness.ends[1].body),
        ("harness", trunk, None)
    );
    assert_eq!(harness.ends[1].position, [0.0, 0.0, 1.6]);
    // Two of each hip, one of each knee and one of the neck.
    assert_eq!(mechanism.axes.len(), 4 * 3 + 1);
    let frame = motion.len() / 3;
    let length = motion.column("harness.length").ok_or("no length")?;
    let first = motion.column("trunk.input.position.x").ok_or("no position")?;
    let at = &motion.row(frame).ok_or("no frame")?[first..first + 3];
    let distance =
        at.iter().zip(harness.ends[1].position).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let recorded = motion.row(frame).ok_or("no frame")?[length];
    // The centre of mass is at the input.
    assert!((distance - recorded).abs() < 1e-12, "{distance} is not {recorded}");
    let zigzags = motion.svg(frame)?.lines().filter(|line| line.matches('L').count() == 15).count();
    assert_eq!(zigzags, 1);
    Ok(())
}

/// Chains in a plane and on a line are drawn with their forces; a closed chain has two points on the ground.
#[test]
fn planes_and_lines_are_drawn() -> Result<(), Box<dyn std::error::Error>> {
    for (motion, ground) in [(motions::four_bar()?, 2), (motions::train()?, 0)] {
        let picture = motion.svg(motion.len() / 3)?;
        let bodies = motion.mechanism().bodies.len();
        assert_eq!(picture.matches("stroke-opacity=\"0.8\"").count(), bodies, "{picture}");
        assert_eq!(picture.matches("h36m-30").count(), ground, "{picture}");
        assert!(picture.matches("<text").count() >= 2 && !picture.contains("NaN"), "{picture}");
        let page = motion.html(&Default::default())?;
        assert!(page.contains("\"dimensions\":1") == (ground == 0));
    }
    Ok(())
}
