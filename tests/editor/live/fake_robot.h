// A small robot that speaks the Groot2 protocol, written from the protocol's description and not
// from the client, so that the two check each other. It can also talk nonsense.
#ifndef COPPICE_TESTS_EDITOR_LIVE_FAKE_ROBOT_H_
#define COPPICE_TESTS_EDITOR_LIVE_FAKE_ROBOT_H_

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

namespace coppice::editor {

class FakeRobot {
 public:
  enum class Mood {
    kGood,
    kGarbage,
    kShortHeader,
    kWrongNumber,
    kError,
    kBadStatus,
    kBadTree,
    kMute
  };

  /// Binds to a free port, or to that one.
  explicit FakeRobot(std::string xml, char tree_id = 'a', int port = 0)
      : socket_(context_, ZMQ_REP), xml_(std::move(xml)), tree_id_(tree_id) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 20);
    socket_.bind("tcp://127.0.0.1:" + (port ? std::to_string(port) : std::string("*")));
    const std::string bound = socket_.get(zmq::sockopt::last_endpoint);
    port_ = std::stoi(bound.substr(bound.rfind(':') + 1));
    thread_ = std::thread([this] { Serve(); });
  }
  ~FakeRobot() {
    stop_ = true;
    thread_.join();
  }

  int port() const { return port_; }
  std::string endpoint() const { return "127.0.0.1:" + std::to_string(port_); }
  int requests(char type) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return requests_[type];
  }
  std::string last_boards() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return last_boards_;
  }
  void SetStatuses(std::string bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    statuses_ = std::move(bytes);
  }
  void SwapTree(std::string xml, char tree_id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    xml_ = std::move(xml);
    tree_id_ = tree_id;
  }
  std::atomic<Mood> mood{Mood::kGood};

 private:
  void Serve() {
    while (!stop_) {
      std::vector<std::string> parts;
      zmq::message_t part;
      if (!socket_.recv(part)) continue;
      parts.push_back(part.to_string());
      while (part.more()) {
        static_cast<void>(socket_.recv(part));
        parts.push_back(part.to_string());
      }
      Answer(parts);
    }
  }

  void Answer(const std::vector<std::string>& parts) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const char type = parts[0].at(1);
    ++requests_[type];
    std::string header = std::string("\x02", 1) + parts[0].substr(1, 5) + std::string(16, tree_id_);
    std::string payload = type == 'T' ? xml_ : type == 'S' ? statuses_ : Boards(parts);
    switch (mood) {
      case Mood::kGood:
        break;
      case Mood::kGarbage:
        return Send({std::string("\x93\x00\xff", 3)});
      case Mood::kShortHeader:
        return Send({header.substr(0, 21), payload});
      case Mood::kWrongNumber:
        header[2] = static_cast<char>(header[2] + 1);
        break;
      case Mood::kError:
        return Send({"error", "not today"});
      case Mood::kBadStatus:
        if (type == 'S') payload += "x";
        break;
      case Mood::kBadTree:
        if (type == 'T') payload = "<root><Behav";
        break;
      case Mood::kMute:
        while (!stop_ && mood == Mood::kMute) std::this_thread::yield();
        break;
    }
    Send({header, payload});
  }

  void Send(const std::vector<std::string>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      socket_.send(zmq::buffer(parts[i]),
                   i + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
    }
  }

  // MessagePack by hand: {"Main": {"goal": "kitchen", "level": 7}}
  std::string Boards(const std::vector<std::string>& parts) {
    last_boards_ = parts.size() > 1 ? parts[1] : "";
    return "\x81\xa4Main\x82\xa4goal\xa7kitchen\xa5level\x07";
  }

  zmq::context_t context_;
  zmq::socket_t socket_;
  std::mutex mutex_;
  std::string xml_;
  char tree_id_;
  std::string statuses_ = std::string("\x01\x00\x01\x02\x00\x0c", 6);
  std::string last_boards_;
  std::map<char, int> requests_;
  int port_ = 0;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_LIVE_FAKE_ROBOT_H_
