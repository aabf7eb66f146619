// Harness functions: each takes any bytes and must neither crash nor hang. A new one has a file of
// its own, a line in CMakeLists.txt and a test in smoke_test.cc.
#ifndef COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_
#define COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_

#include <string_view>

namespace coppice::fuzz {

/// The bytes as a log of BehaviorTree.CPP, and as the contents of one: the time at which it starts
/// (8 bytes), the XML up to a zero byte, the transitions. What comes of it is exported. Returns 0
/// if it is refused, 1 if nothing happens in it, 2.
int FuzzBtlog(std::string_view bytes);

/// The bytes as what a robot says to a client: 'G' for one that knows the Groot2 protocol only,
/// then frames as in frames.h whose type says what it is (fuzz_client.cc). Each command must be
/// answered once; what is told must fit together. Returns how far it came: 0 no tree, 1 no state, 2
/// no tick, 3.
int FuzzClient(std::string_view bytes);

/// The bytes as a cloud of a 3-D lidar: its sizes, its fields, its points. Returns 0 if it is
/// refused, 1 if no point of it can be used, 2.
int FuzzCloud(std::string_view bytes);

/// The bytes as a message of multicast DNS, to a robot and to who looks for robots. Texts of robots
/// must be fit to be shown, and an answer must be read as it was meant. Returns 0 if it is neither,
/// 1 if robots are found in it, 2 if it is a question that a robot answers.
int FuzzDiscovery(std::string_view bytes);

/// The bytes as an XML file: parse, resolve, compile, tick. Checks that every position lies in the
/// text and that what compiles is idle after a halt. Returns how far it came: 0 no document, 1 an
/// incomplete project, 2 no program, 3 ticked.
int FuzzDocument(std::string_view bytes);

/// The first 16 bytes as choices of edits, the others as an XML file, which is upgraded, edited and
/// restored by undoing. Checks that edits are in order and that the restored text is the old one.
/// Returns 0 if it is no XML, else 1 and the number of edits done, at most 4.
int FuzzEdit(std::string_view bytes);

/// The bytes as frames of a history (frames.h), sealed here; and each payload as a frame as it is.
/// What is handed out must fit the tree. Returns how far it came: 0 no tree, 1 no state, 2 no
/// tick, 3.
int FuzzHistory(std::string_view bytes);

/// The bytes as a literal of each built-in type. What is accepted must print to a text that is
/// accepted again with the same result. Returns the number of types that took it.
int FuzzLiteral(std::string_view bytes);

/// The bytes as requests to a live view, a line each: one byte that says who asks and when, the
/// type of the request, its second part. The tree is ticked in between. Returns how many were
/// answered with something else than an error.
int FuzzLive(std::string_view bytes);

/// The bytes as a map of many sessions, unpacked. What is read must fit together, and be read again
/// when it is written. Returns 0 if it is refused, 1 if it was read.
int FuzzMap(std::string_view bytes);

/// The bytes as the definition of a message's type, up to a zero byte, and a message of it. What is
/// stored must be JSON, and give a message as long when it is read. Returns 0 if the definition is
/// refused, 1 if the message is, 2.
int FuzzMessage(std::string_view bytes);

/// The bytes as a picture of a camera: behind a 'D' of depths, else in colour. Returns 0 if it is
/// refused, 1 if it was read.
int FuzzPicture(std::string_view bytes);

/// The bytes as a record on the disk: frames (frames.h), some types of which write bytes as they
/// are, cut the file off, begin another one, or open a reader that is refreshed later
/// (fuzz_record.cc). Cursors must find their way, and what they tell must fit the tree. Returns 0
/// if it is no record, 1 if nothing happens in it, 2.
int FuzzRecord(std::string_view bytes);

/// The bytes as a robot of ZeroMQ to a client: which one ('N' without a token, 'C' with one, 'S'
/// one that publishes), then frames as in frames.h, each a step of what it says (fuzz_robot.cc).
/// No message may be over its limits; what the client says must be frames. Returns how far it came:
/// 0 not opened, 1 opened, 2 a message.
int FuzzRobot(std::string_view bytes);

/// The bytes as a file of scenarios, played with a small tree. Returns 0 if it is none, 1 if it
/// would take long, 2 if it was played.
int FuzzScenario(std::string_view bytes);

/// The bytes as a script, on keys of all kinds. Every position must lie in the text; Run and Test
/// may throw nothing but ScriptError. Returns how far it came: 0 refused, 1 failed when run, 2 ran.
int FuzzScript(std::string_view bytes);

/// The bytes as a WAV file, of a visitor's or of a service. Returns 0 if it is refused, 1 if there
/// is nothing in it, 2.
int FuzzWav(std::string_view bytes);

/// The bytes as what somebody sends to the port for browsers; behind a 'W' over a WebSocket that is
/// open already. The port must close the connection. Returns how far it came: 0 no answer, 1 an
/// answer of HTTP, 2 no message over the WebSocket, 3 a message.
int FuzzWeb(std::string_view bytes);

/// The bytes as a client of ZeroMQ: who it is ('N' without a token, 'C', 'R' with one, 'S' a
/// listener), then frames as in frames.h, each a step of what it says: bytes as they are, or what
/// CURVE needs to be read at all (fuzz_zmtp.cc). Its requests are answered by a tree; what the
/// robot says must be frames. Returns how far it came: 0 not let in, 1 let in, 2 a request, 3 an
/// answer that is no error.
int FuzzZmtp(std::string_view bytes);

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_FUZZ_TARGETS_H_
