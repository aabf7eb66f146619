// Inputs from which fuzzing begins, one or more for each harness that cannot begin with a tree.
#ifndef COPPICE_TESTS_FUZZ_SEEDS_H_
#define COPPICE_TESTS_FUZZ_SEEDS_H_

#include <string>
#include <utility>
#include <vector>

namespace coppice::fuzz {

/// Name of the harness, and an input.
std::vector<std::pair<std::string, std::string>> AllSeeds();

/// A tree of two nodes and a slot, how it stands, and some ticks.
std::string SomeHistory();
/// The same as a record that was read while it grew, and goes on in a second file behind a damage.
std::string SomeRecord();
/// A tree with a subtree, and transitions.
std::string SomeBtlog();
/// Requests to a live view, a line each.
std::string SomeRequests();
/// What a robot says to a client: one with Coppice, and one with the Groot2 protocol.
std::string SomeTalk();
std::string SomeGroot2Talk();
/// What a browser sends: a page and a WebSocket are asked for; messages over one that is open.
std::string SomeWebRequest();
std::string SomeWebMessages();
/// What a client of ZeroMQ says: requests, with that kind of FuzzZmtp; a listener's topics.
std::string SomeZmtpTalk(char kind);
std::string SomeZmtpTopics();
/// What a robot is asked that tells the network of itself, and what it answers.
std::string SomeDiscoveryQuestion();
std::string SomeDiscoveryAnswer();
/// What a robot says to a client of ZeroMQ, with that kind of FuzzRobot.
std::string SomeZmtpRobot(char kind);

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_SEEDS_H_
