#include "tests/fuzz/seeds.h"

#include "bt_core/frames/payload_coding.h"
#include "bt_core/frames/tick_coding.h"
#include "tests/fuzz/frames.h"

namespace coppice::fuzz {
namespace {

constexpr char kRequests[] = R"(1T
1S
1BMain;inner
1I{"enabled": true, "uid": 2, "mode": 1, "once": false, "desired_status": "FAILURE", "position": 0}
1I[{"enabled": true, "uid": 1, "mode": 0, "once": true, "desired_status": "SKIPPED", "position": 1}]
1U{"uid": 2, "position": 0, "desired_status": "SUCCESS", "remove_when_done": true}
1R{"uid": 1, "position": 1}
1D
1A
1X
1rstart
1t
1C{"do": "hello", "protocol": 1, "name": "x"}
2C{"do": "hello"}
1C{"do": "subscribe", "tree": 0, "run": "00", "from": 3, "window": 1000}
1C{"do": "subscribe", "from": "now"}
1C{"do": "ack", "subscription": 1, "next": 2}
1C{"do": "hook", "node": "inner/a", "action": "replace", "status": "FAILURE", "times": 2}
2C{"do": "hook", "node": 2, "condition": "n > 0 && word == 'x'", "from_hit": 2, "action": "stop"}
2C{"do": "hook", "hook": 2, "node": "s", "action": "delay", "delay_ms": 1.5, "enabled": false}
1C{"do": "enable", "hook": 1, "enabled": false}
1C{"do": "hooks"}
1C{"do": "write", "scope": "inner", "key": "number", "value": 7}
1C{"do": "write", "key": "n", "text": "8"}
1C{"do": "statistics"}
1C{"do": "pause"}
1C{"do": "step", "to": "node"}
1C{"do": "continue", "result": "SUCCESS"}
1C{"do": "trees"}
1C{"do": "unhook", "hook": 1}
1C{"do": "unsubscribe", "subscription": 1}
1C{"do": "ping"}
2C{"do": "bye"}
)";

std::string Text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

void AppendTo(FrameType type, const Bytes& payload, std::string& out) {
  AppendFrame(static_cast<unsigned char>(type), Text(payload), out);
}

TreeDescription SomeTree() {
  TreeDescription tree;
  tree.documents = {{"a.xml", "<root/>"}};
  tree.nodes.resize(2);
  tree.nodes[1].path = "top";
  tree.nodes[1].ports = {{"port", SlotIndex{0}}};
  tree.slots.resize(1);
  return tree;
}

std::string TreeAndState() {
  std::string frames;
  Bytes payload;
  Encoder out(payload);
  EncodeTree(SomeTree(), out);
  AppendTo(FrameType::kTree, payload, frames);
  payload.clear();
  const HistoryState state{{}, 1, Time(Duration(1)), {{}, {}}, {{}, {}}, {"\1text"}};
  EncodeStateHead(state, out);
  EncodeStateBody(state, out);
  AppendTo(FrameType::kState, payload, frames);
  return frames;
}

std::string Ticks(std::uint64_t first, std::uint64_t behind) {
  std::string frames;
  TickEncoder ticks;
  EventWriter words;
  words.Add(EventCode::kWrite, 0, 1, "\1new");
  words.Text(NodeIndex{1}, EventText::kMessage, "because");
  words.Status(NodeIndex{1}, Status::kSuccess);
  words.Status(kRootNode, Status::kRunning);
  for (std::uint64_t i = first; i < behind; ++i) {
    Bytes payload;
    const Time start = TimeFromNanoseconds(static_cast<std::int64_t>(1000 * i));
    ticks.Encode({i, start, Duration(0), Status::kRunning, true, words.words()}, payload);
    AppendTo(FrameType::kEvents, payload, frames);
  }
  return frames;
}

std::string End(HistoryEnd::Cause cause) {
  Bytes payload;
  Encoder out(payload);
  EncodeEnd({cause, Time(Duration(4000)), 4}, out);
  std::string frame;
  AppendTo(FrameType::kEnd, payload, frame);
  return frame;
}

// A part of what a robot says (fuzz_client.cc).
std::string Say(char what, const std::string& body) {
  std::string part;
  AppendFrame(static_cast<unsigned char>(what), body, part);
  return part;
}

// Nodes 1 (root), 2 (SubTree), 3 (within).
constexpr char kFullTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath="">
<Sequence _uid="1"><SubTree ID="Inner" _fullpath="Inner::2" _uid="2"/></Sequence></BehaviorTree>
<BehaviorTree ID="Inner" _fullpath="Inner::2"><Go name="go" _uid="3"/></BehaviorTree>
<TreeNodesModel><Action ID="Go"><input_port name="goal"/></Action></TreeNodesModel></root>)";

std::string Bytes48(std::uint64_t number) {
  std::string bytes;
  for (int shift = 0; shift < 48; shift += 8) bytes += static_cast<char>(number >> shift);
  return bytes;
}

// Time [us], number of the node, status.
std::string Transition(std::uint64_t time, char uid, Status status) {
  return Bytes48(time) + uid + '\0' + static_cast<char>(status);
}

std::string SomeTransitions() {
  return Transition(0, 3, Status::kRunning) + Transition(10, 2, Status::kRunning) +
         Transition(20, 1, Status::kRunning) + Transition(5000, 3, Status::kSuccess) +
         Transition(5010, 2, Status::kSuccess) + Transition(5020, 1, Status::kSuccess) +
         Transition(5030, 3, Status::kIdle);
}

std::string ZmtpGreeting(const std::string& mechanism) {
  std::string greeting = std::string("\xff\0\0\0\0\0\0\0\1\x7f\3\0", 12) + mechanism;
  greeting.resize(64);
  return greeting;
}

std::string SocketType(const std::string& type) {
  return "\x0bSocket-Type" + std::string("\0\0\0", 3) + static_cast<char>(type.size()) + type;
}

std::string Statuses(char root, char subtree, char leaf) {
  return {1, 0, root, 2, 0, subtree, 3, 0, leaf};
}

}  // namespace

std::string SomeHistory() { return TreeAndState() + Ticks(2, 5); }

std::string SomeRecord() {
  return TreeAndState() + Ticks(2, 3) + Say('\xf3', "") + End(HistoryEnd::Cause::kContinued) +
         Say('\xf2', "") + TreeAndState() + Ticks(2, 4) + Say('\xf0', "damage") + TreeAndState() +
         Ticks(2, 5) + End(HistoryEnd::Cause::kClosed) + Say('\xf1', "cut");
}

std::string SomeBtlog() {
  return std::string("\1\2\3\4\5\6\0\0", 8) + kFullTree + '\0' + SomeTransitions();
}

std::string SomeRequests() { return kRequests; }

std::string SomeTalk() {
  return "C" + Say('R', R"({"protocol":1,"pictures":true,"trees":[{"tree":0,"name":"Main"}]})") +
         Say('R', "{}") +
         Say('R', R"({"subscription":0,"run":"11111111111111111111111111111111","next":0})") +
         Say('F', SomeHistory()) + Say('c', std::string("\0", 1)) + Say('R', "{}") +
         Say('E', R"({"event":"stopped","tree":0,"stop":{"where":"before","node":1,"hook":2}})") +
         Say('E',
             R"({"event":"picture","name":"face","width":2,"height":1,"rgb":"00ff10203040"})") +
         Say('c', "\4top") + Say('R', R"({"hook":3,"remark":"so"})") +
         Say('E', R"({"event":"trees","trees":[{"tree":0,"name":"Main"},{"tree":1}]})") +
         Say('\x14', "") + Say('c', "\3") + Say('R', R"({"error":"no"})") + Say('F', Ticks(5, 7)) +
         Say('E', R"({"event":"released"})") +
         Say('R', R"({"protocol":1,"trees":[{"tree":0,"name":"Main"}]})");
}

std::string SomeGroot2Talk() {
  const std::string boards = "\x81\xa4Main\x82\xa1k\x01\xa1t\xa2so";
  const std::string hooks =
      R"([{"enabled":true,"uid":3,"mode":0,"once":false,"desired_status":"","position":0}])";
  return "G" + Say('R', Statuses(0, 0, 0)) + Say('R', kFullTree) + Say('R', boards) +
         Say('R', hooks) + Say('R', "1700000000000000") + Say('R', Statuses(1, 1, 1)) +
         Say('\2', "") + Say('R', SomeTransitions()) + Say('R', Statuses(2, 2, 12)) +
         Say('R', boards) + Say('R', hooks) + Say('c', "\4Inner::2/go") + Say('R', "") +
         Say('N', "3") + Say('c', "\3") + Say('R', "") + Say('c', "\5") + Say('R', "") +
         Say('\2', "") + Say('e', "Busy") + Say('O', Statuses(0, 0, 0)) + Say('R', kFullTree);
}

std::string SomeWebRequest() {
  return "GET /index.html HTTP/1.1\r\nHost: localhost\r\nConnection: keep-alive\r\n\r\n"
         "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
         "Origin: http://localhost\r\nSec-WebSocket-Protocol: coppice-live\r\n\r\n";
}

// A ping, a message in two fragments, another with a pong before it, the end.
std::string SomeWebMessages() {
  using namespace std::string_literals;
  return "W\x89\x81\0\0\0\0p\x02\x85\0\0\0\0\1\0\0\0a\x80\x84\0\0\0\0\0\0\0\0"
         "\x8a\x80\1\2\3\4\x82\x86\0\0\0\0\2\0\0\0hi\x88\x82\0\0\0\0\x03\xe8"s;
}

std::string SomeZmtpTalk(char kind) {
  const bool is_secret = kind == 'C' || kind == 'R';
  std::string talk = kind + Say('b', ZmtpGreeting(is_secret ? "CURVE" : "NULL"));
  if (is_secret) talk += Say('h', "");
  talk += Say('i', SocketType("DEALER")) + Say('p', std::string("\4PING\0\1again", 12));
  std::string_view lines = kRequests;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(line.size() + 1);
    const std::string header = std::string("\2") + line[1] + std::string("\7\0\0\0", 4);
    const bool has_body = line.size() > 2;
    talk += Say('M', "") + Say(has_body ? 'M' : 'm', header);
    if (has_body) talk += Say('m', std::string(line.substr(2)));
  }
  return talk;
}

std::string SomeZmtpTopics() {
  return "S" + Say('b', ZmtpGreeting("NULL")) + Say('i', SocketType("SUB")) + Say('m', "\1note") +
         Say('m', std::string("\0note", 5));
}

std::string SomeZmtpRobot(char kind) {
  std::string talk = kind + Say('b', ZmtpGreeting(kind == 'C' ? "CURVE" : "NULL"));
  if (kind == 'C') talk += Say('h', "");
  talk += Say('i', SocketType(kind == 'S' ? "PUB" : "ROUTER")) +
          Say('p', std::string("\4PING\0\1again", 12));
  for (int i = 0; i < 8; ++i) talk += Say('M', "") + Say('M', "header") + Say('m', "body");
  return talk;
}

std::string SomeDiscoveryQuestion() {
  using namespace std::string_literals;
  return "\x12\x34\0\0\0\1\0\0\0\0\0\0\x08_coppice\x04_tcp\5local\0\0\x0c\0\1"s;
}

// The place and the words of a robot, whose name is the first of them.
std::string SomeDiscoveryAnswer() {
  using namespace std::string_literals;
  return "\x12\x34\x84\0\0\0\0\2\0\0\0\0"
         "\4sobi\x08_coppice\x04_tcp\5local\0\0\x21\0\1\0\0\0\x0a\0\x0d"
         "\0\0\0\0\6\x83\4sobi\xc0\x1f"
         "\xc0\x0c\0\x10\0\1\0\0\0\x0a\0\x0c\x0btree=Patrol"s;
}

std::vector<std::pair<std::string, std::string>> AllSeeds() {
  return {{"btlog", SomeBtlog()},
          {"client", SomeTalk()},
          {"client", SomeGroot2Talk()},
          {"history", SomeHistory()},
          {"live", SomeRequests()},
          {"record", SomeRecord()},
          {"web", SomeWebRequest()},
          {"web", SomeWebMessages()},
          {"zmtp", SomeZmtpTalk('N')},
          {"zmtp", SomeZmtpTalk('C')},
          {"zmtp", SomeZmtpTalk('R')},
          {"zmtp", SomeZmtpTopics()},
          {"robot", SomeZmtpRobot('N')},
          {"robot", SomeZmtpRobot('C')},
          {"robot", SomeZmtpRobot('S')},
          {"discovery", SomeDiscoveryQuestion()},
          {"discovery", SomeDiscoveryAnswer()}};
}

}  // namespace coppice::fuzz
