//! The `HIERARCHY` section.

use std::collections::HashSet;

use nalgebra::Vector3;

use crate::bvh::error::location;
use crate::bvh::names::{self, NameDecoder};
use crate::bvh::number::Decimals;
use crate::bvh::repairs::{Repair, Repairs};
use crate::bvh::{Axis, Channel, END_SITE, Error, ErrorKind, Joint, JointKind, Limits, Options, number};
use crate::notice::{Code, Location, Notice};

/// Builds the joints from lines of text.
#[derive(Debug)]
pub(crate) struct Hierarchy {
    limits: Limits,
    decode_names: NameDecoder,
    expect: Expect,
    /// Complete and incomplete joints in file order, without their names.
    joints: Vec<Joint>,
    /// Name of each joint as bytes of the file.
    names: Vec<Vec<u8>>,
    /// Joints whose braces are open, outermost first.
    open: Vec<usize>,
    /// True for each joint whose `OFFSET` has been read.
    offset_seen: Vec<bool>,
    decimals: Decimals,
    repairs: Repairs,
    locations: JointLocations,
    /// Names of roots and joints so far.
    seen: HashSet<Vec<u8>>,
    /// Number and text of the last line that is not blank.
    last: (usize, Vec<u8>),
}

/// Locations of joints that notices are about.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct JointLocations {
    /// Name of the second root.
    pub second_root: Option<Location>,
    /// First name that another joint has, too.
    pub duplicate: Option<Location>,
    /// First name that is not UTF-8.
    pub encoding: Option<Location>,
}

/// A complete hierarchy.
#[derive(Debug)]
pub(crate) struct HierarchySection {
    pub joints: Vec<Joint>,
    /// Name of the encoding of the joint names, if they are not Unicode.
    pub name_encoding: Option<&'static str>,
    pub decimals: Decimals,
    pub locations: JointLocations,
    pub notices: Vec<Notice>,
}

/// Token that must come next.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Expect {
    Start,
    RootOrMotion,
    Name(JointKind),
    OpenBrace,
    Body,
    Offset(usize),
    ChannelCount,
    ChannelNames { declared: usize },
}

/// Result of reading a line.
pub(crate) enum Progress {
    Hierarchy,
    /// `MOTION` was read; the rest of the line begins at this byte.
    Motion(usize),
}

impl Hierarchy {
    pub fn new(options: &Options) -> Hierarchy {
        Hierarchy {
            limits: options.limits,
            decode_names: options.decode_names,
            expect: Expect::Start,
            joints: Vec::new(),
            names: Vec::new(),
            open: Vec::new(),
            offset_seen: Vec::new(),
            decimals: Decimals::default(),
            repairs: Repairs::default(),
            locations: JointLocations::default(),
            seen: HashSet::new(),
            last: Default::default(),
        }
    }

    /// Returns the joints with their names, and the notices, in file order.
    pub fn take(&mut self) -> HierarchySection {
        let mut joints = std::mem::take(&mut self.joints);
        let (names, name_encoding) = names::decode(&std::mem::take(&mut self.names), self.decode_names);
        for (joint, name) in joints.iter_mut().zip(names) {
            joint.name = name;
        }
        let mut notices = self.repairs.take_notices(&joints);
        if let Some(encoding) = name_encoding {
            let text = format!(
                "The joint names are not UTF-8. They are shown as {encoding}, which is a guess; saved files keep \
                 their bytes."
            );
            notices.push(Notice { code: Code::NameEncoding, location: self.locations.encoding, text });
        }
        let (decimals, locations) = (self.decimals, self.locations);
        HierarchySection { joints, name_encoding, decimals, locations, notices }
    }

    /// Reads one line.
    pub fn line(&mut self, line: usize, text: &[u8]) -> Result<Progress, Error> {
        let mut at = number::skip_blanks(text, 0);
        if at < text.len() {
            self.last.0 = line;
            self.last.1.clear();
            self.last.1.extend_from_slice(text.trim_ascii_end());
        }
        while at < text.len() && !number::is_comment(&text[at..]) {
            if self.expect == Expect::Start {
                at = self.start(line, text, at)?;
            } else if let Expect::Name(kind) = self.expect {
                at = self.name(kind, line, text, at)?;
            } else {
                let word = word_or_brace(&text[at..]);
                if self.expect == Expect::RootOrMotion && word.eq_ignore_ascii_case(b"MOTION") {
                    if self.joints.is_empty() {
                        return Err(Error::at(ErrorKind::NoJoints, line, text, at));
                    }
                    return Ok(Progress::Motion(at + word.len()));
                }
                at += self.word(word, line, text, at)?;
            }
            at = number::skip_blanks(text, at);
        }
        // A name may be missing; the brace is then on the next line.
        if let Expect::Name(kind) = self.expect {
            self.name(kind, line, text, text.len())?;
        }
        Ok(Progress::Hierarchy)
    }

    /// True if braces are open.
    pub fn is_open(&self) -> bool {
        !self.open.is_empty()
    }

    /// Checks that the file may end here.
    pub fn finish(&self) -> Result<(), Error> {
        let kind = match self.expect {
            Expect::Start => ErrorKind::Empty,
            _ if !self.open.is_empty() || self.expect != Expect::RootOrMotion => {
                let (line, text) = &self.last;
                let kind = ErrorKind::UnclosedBraces { open: self.open.len() };
                return Err(Error::at(kind, *line, text, text.len()));
            }
            _ if self.joints.is_empty() => ErrorKind::NoJoints,
            _ => return Ok(()),
        };
        Err(Error::in_file(kind))
    }

    fn start(&mut self, line: usize, text: &[u8], at: usize) -> Result<usize, Error> {
        self.expect = Expect::RootOrMotion;
        let word = word_or_brace(&text[at..]);
        if word.eq_ignore_ascii_case(b"HIERARCHY") {
            return Ok(at + word.len());
        }
        if word.eq_ignore_ascii_case(b"ROOT") {
            self.repairs.add(Repair::MissingHierarchy, || location(line, text, at));
            return Ok(at);
        }
        Err(match guess_format(&text[at..]) {
            Some(other) => Error::in_file(ErrorKind::NotBvh(other)),
            None => unexpected("HIERARCHY", line, text, at),
        })
    }

    /// Reads a name: the rest of the line up to a brace.
    fn name(&mut self, kind: JointKind, line: usize, text: &[u8], at: usize) -> Result<usize, Error> {
        let len = names::name_len(&text[at..]);
        let name = text[at..at + len].trim_ascii();
        if name.is_empty() {
            self.repairs.add(Repair::MissingName, || location(line, text, at));
        }
        self.push(kind, name, line, text, at)?;
        Ok(at + len)
    }

    fn push(
        &mut self,
        kind: JointKind,
        name: &[u8],
        line: usize,
        text: &[u8],
        at: usize,
    ) -> Result<(), Error> {
        if self.joints.len() == self.limits.joints {
            return Err(Error::at(ErrorKind::TooManyJoints(self.limits.joints), line, text, at));
        }
        if self.open.len() == self.limits.depth {
            return Err(Error::at(ErrorKind::TooDeep(self.limits.depth), line, text, at));
        }
        let parent = self.open.last().copied();
        if let Some(parent) = parent {
            self.make_joint(parent, line, text, at);
        }
        let locations = &mut self.locations;
        if parent.is_none() && !self.joints.is_empty() {
            locations.second_root.get_or_insert_with(|| location(line, text, at));
        }
        if locations.encoding.is_none() && std::str::from_utf8(name).is_err() {
            locations.encoding = Some(location(line, text, at));
        }
        if kind != JointKind::EndSite && !self.seen.insert(name.to_vec()) {
            locations.duplicate.get_or_insert_with(|| location(line, text, at));
        }
        let (name, bytes) = (String::new(), name.to_vec());
        self.joints.push(Joint { name, kind, parent, offset: Vector3::zeros(), channels: Vec::new() });
        self.names.push(bytes);
        self.offset_seen.push(false);
        self.expect = Expect::OpenBrace;
        Ok(())
    }

    /// Reads one word and returns the number of bytes used.
    fn word(&mut self, word: &[u8], line: usize, text: &[u8], at: usize) -> Result<usize, Error> {
        let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
        match self.expect {
            Expect::RootOrMotion if is("ROOT") => self.expect = Expect::Name(JointKind::Root),
            Expect::RootOrMotion => return Err(unexpected("ROOT or MOTION", line, text, at)),
            Expect::OpenBrace if is("{") => {
                self.open.push(self.joints.len() - 1);
                self.expect = Expect::Body;
            }
            Expect::OpenBrace => return Err(unexpected("{", line, text, at)),
            Expect::Body if is("OFFSET") => self.expect = Expect::Offset(0),
            Expect::Body if is("CHANNELS") => self.expect = Expect::ChannelCount,
            Expect::Body if is("JOINT") => self.expect = Expect::Name(JointKind::Joint),
            Expect::Body if is("End") => {
                self.push(JointKind::EndSite, END_SITE.as_bytes(), line, text, at)?;
                // The text between `End` and the brace is `Site` and perhaps a name.
                return Ok(names::name_len(&text[at..]));
            }
            Expect::Body if is("}") => self.close(line, text, at),
            Expect::Body if is("MOTION") => {
                return Err(Error::at(ErrorKind::UnclosedBraces { open: self.open.len() }, line, text, at));
            }
            Expect::Body => return Err(unexpected(BODY, line, text, at)),
            Expect::Offset(axis) => return self.offset(axis, line, text, at),
            Expect::ChannelCount => {
                let declared: Option<usize> =
                    std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
                let Some(declared) = declared else {
                    return Err(unexpected("the number of channels", line, text, at));
                };
                // A second list continues the first.
                let listed = self.open.last().map_or(0, |&joint| self.joints[joint].channels.len());
                self.expect = Expect::ChannelNames { declared: listed.saturating_add(declared) };
            }
            Expect::ChannelNames { declared } => return self.channel(declared, word, line, text, at),
            Expect::Start | Expect::Name(_) => unreachable!("taken by line()"),
        }
        Ok(word.len())
    }

    /// Makes an end site with channels or joints a joint.
    fn make_joint(&mut self, joint: usize, line: usize, text: &[u8], at: usize) {
        if self.joints[joint].kind == JointKind::EndSite {
            self.joints[joint].kind = JointKind::Joint;
            self.repairs.add(Repair::EndSite, || location(line, text, at));
        }
    }

    fn close(&mut self, line: usize, text: &[u8], at: usize) {
        if let Some(joint) = self.open.pop()
            && !self.offset_seen[joint]
        {
            self.repairs.add(Repair::MissingOffset { joint }, || location(line, text, at));
        }
        self.expect = if self.open.is_empty() { Expect::RootOrMotion } else { Expect::Body };
    }

    fn offset(&mut self, axis: usize, line: usize, text: &[u8], at: usize) -> Result<usize, Error> {
        let Some(number) = number::parse_leading(word_or_brace(&text[at..])) else {
            return Err(unexpected("a number", line, text, at));
        };
        let limit = self.limits.value;
        if number.value.abs() > limit {
            let found = String::from_utf8_lossy(&text[at..at + number.len]).chars().take(40).collect();
            let kind = ErrorKind::LargeValue { found, limit, place: "OFFSET".into() };
            return Err(Error::at(kind, line, text, at));
        }
        self.decimals.record(number.mark, line, text, at)?;
        let joint = *self.open.last().expect("OFFSET is read within a joint");
        if axis == 0 && std::mem::replace(&mut self.offset_seen[joint], true) {
            self.repairs.add(Repair::SecondOffset { joint }, || location(line, text, at));
        }
        self.joints[joint].offset[axis] = number.value;
        self.expect = if axis == 2 { Expect::Body } else { Expect::Offset(axis + 1) };
        Ok(number.len)
    }

    fn channel(
        &mut self,
        declared: usize,
        word: &[u8],
        line: usize,
        text: &[u8],
        at: usize,
    ) -> Result<usize, Error> {
        let joint = *self.open.last().expect("CHANNELS is read within a joint");
        if is_keyword(word) {
            let listed = self.joints[joint].channels.len();
            if listed != declared {
                let repair = Repair::ChannelCount { joint, declared, listed };
                self.repairs.add(repair, || location(line, text, at));
            }
            self.expect = Expect::Body;
            return Ok(0);
        }
        let Some(channel) = parse_channel(word) else {
            // After all declared channels, the word is a misspelled keyword.
            if self.joints[joint].channels.len() == declared {
                return Err(unexpected(BODY, line, text, at));
            }
            let name = String::from_utf8_lossy(word).into_owned();
            return Err(Error::at(ErrorKind::UnknownChannel(name), line, text, at));
        };
        self.make_joint(joint, line, text, at);
        if matches!(channel, Channel::Scale(_)) {
            self.repairs.add(Repair::ScaleChannel, || location(line, text, at));
        }
        self.joints[joint].channels.push(channel);
        Ok(word.len())
    }
}

/// Keywords between the braces of a joint.
const BODY: &str = "OFFSET, CHANNELS, JOINT, End Site or }";

fn unexpected(expected: &'static str, line: usize, text: &[u8], at: usize) -> Error {
    let found: String = String::from_utf8_lossy(word_or_brace(&text[at..])).chars().take(40).collect();
    Error::at(ErrorKind::Unexpected { expected, found }, line, text, at)
}

/// Returns the bytes up to the next blank or brace; a brace is a separate word.
fn word_or_brace(bytes: &[u8]) -> &[u8] {
    let is_brace = |byte: &u8| matches!(byte, b'{' | b'}');
    if bytes.first().is_some_and(is_brace) {
        return &bytes[..1];
    }
    let word = number::word(bytes);
    &word[..word.iter().position(is_brace).unwrap_or(word.len())]
}

fn is_keyword(word: &[u8]) -> bool {
    ["{", "}", "OFFSET", "CHANNELS", "JOINT", "End", "ROOT", "MOTION"]
        .iter()
        .any(|keyword| word.eq_ignore_ascii_case(keyword.as_bytes()))
}

fn parse_channel(word: &[u8]) -> Option<Channel> {
    let (axis, kind) = word.split_first()?;
    let axis = match axis.to_ascii_uppercase() {
        b'X' => Axis::X,
        b'Y' => Axis::Y,
        b'Z' => Axis::Z,
        _ => return None,
    };
    if kind.eq_ignore_ascii_case(b"position") {
        Some(Channel::Position(axis))
    } else if kind.eq_ignore_ascii_case(b"rotation") {
        Some(Channel::Rotation(axis))
    } else if kind.eq_ignore_ascii_case(b"scale") {
        Some(Channel::Scale(axis))
    } else {
        None
    }
}

/// Returns the probable format of a file that is not BVH.
fn guess_format(text: &[u8]) -> Option<&'static str> {
    let begins = |with: &[u8]| text.len() >= with.len() && text[..with.len()].eq_ignore_ascii_case(with);
    if begins(b"PK\x03\x04") {
        Some("a zip archive")
    } else if begins(b"Kaydara FBX") || begins(b"; FBX") {
        Some("FBX")
    } else if begins(b"<!doctype") || begins(b"<html") || begins(b"<!--") {
        Some("a web page")
    } else if begins(b"glTF") {
        Some("glTF")
    } else if begins(b"<?xml") {
        Some("an XML document")
    } else if begins(b"{\\rtf") {
        Some("a rich text document")
    } else if begins(b"{") {
        Some("JSON")
    } else if begins(b"%PDF") {
        Some("a PDF document")
    } else if begins(b":ASF") || begins(b":version") || begins(b":FULLY-SPECIFIED") {
        Some("an ASF or AMC file")
    } else if text.iter().any(|&byte| byte < b' ' && byte != b'\t')
        || !text[0].is_ascii() && std::str::from_utf8(text).is_err()
    {
        Some("binary data")
    } else {
        None
    }
}
