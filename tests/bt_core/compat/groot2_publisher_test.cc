// What Groot2 asks of a program that has a Groot2Publisher, byte by byte.
#include "behaviortree_cpp/loggers/groot2_publisher.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <zmq.hpp>

#include "behaviortree_cpp/xml_parsing.h"
#include "tests/bt_core/compat/logged_tree.h"
#include "tests/bt_core/live/live_client.h"

namespace {

using compat_test::LoggedTree;
using coppice::Parts;

// On two neighbouring ports that nobody has; below those that Linux gives to whoever connects.
class PublisherOnFreePorts {
 public:
  explicit PublisherOnFreePorts(const BT::Tree& tree) {
    std::random_device chance;
    std::uniform_int_distribution<int> ports(20000, 32000);
    for (int tries = 0; !publisher_; ++tries) {
      port_ = static_cast<std::uint16_t>(ports(chance));
      try {
        publisher_.emplace(tree, port_);
      } catch (const BT::RuntimeError&) {
        if (tries == kMostTries) throw;
      }
    }
  }
  BT::Groot2Publisher* operator->() { return &*publisher_; }
  std::uint16_t port() const { return port_; }

 private:
  static constexpr int kMostTries = 100;
  std::optional<BT::Groot2Publisher> publisher_;
  std::uint16_t port_ = 0;
};

struct Groot2 : testing::Test {
  static std::string Header(char kind) { return {'\x02', kind, '\x11', '\x22', '\x33', '\x44'}; }
  Parts Ask(char kind) {
    client.Send({Header(kind)});
    return client.Receive();
  }
  Parts Ask(char kind, const std::string& more) {
    client.Send({Header(kind), more});
    return client.Receive();
  }
  // "node:status ..."
  std::string Statuses() {
    const std::string payload = Ask('S').at(1);
    std::string text;
    for (std::size_t at = 0; at + 3 <= payload.size(); at += 3) {
      text += std::to_string(payload[at]) + ":" + std::to_string(payload[at + 2]) + " ";
    }
    return text;
  }
  // The publisher's thread learns of a tick while it goes on, and some of it later than the rest:
  // asks until the statuses are the wanted ones, for half a minute.
  std::string StatusesUntil(const std::string& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::string statuses = Statuses();
    while (statuses != wanted && std::chrono::steady_clock::now() < deadline) statuses = Statuses();
    return statuses;
  }

  LoggedTree logged;
  PublisherOnFreePorts publisher{logged.tree};
  coppice::SocketClient client{zmq::socket_type::req, publisher.port()};
};

TEST_F(Groot2, AReplyBeginsWithTheHeaderOfTheRequestAndTheNumberOfTheTree) {
  const Parts first = Ask('S');
  const Parts second = Ask('S');
  ASSERT_EQ(first.size(), 2U);
  ASSERT_EQ(first[0].size(), 22U);
  EXPECT_EQ(first[0].substr(0, 6), Header('S'));
  EXPECT_EQ(first[0], second[0]);
}

TEST_F(Groot2, TheWholeTreeComesAsXmlWithNumbers) {
  const Parts reply = Ask('T');
  ASSERT_EQ(reply.size(), 2U);
  for (const char* part : {"<root BTCPP_format=\"4\"", "ID=\"Main\"", "_fullpath=\"inner\"",
                           "_uid=\"3\"", "<TreeNodesModel>", "ID=\"TwoTicks\""}) {
    EXPECT_NE(reply[1].find(part), std::string::npos) << part << "\n" << reply[1];
  }
}

TEST_F(Groot2, StatusesAreThreeBytesANode) {
  logged.tree.tickExactlyOnce();
  const std::string running = "1:1 2:1 3:1 4:0 5:0 ";
  EXPECT_EQ(StatusesUntil(running), running);
}

TEST_F(Groot2, WhatANodeDidLastIsSeenAfterItsEnd) {
  logged.tree.tickExactlyOnce();
  logged.tree.tickExactlyOnce();
  const std::string ended = "1:12 2:13 3:12 4:12 5:12 ";
  EXPECT_EQ(StatusesUntil(ended), ended);
}

TEST_F(Groot2, ABlackboardComesAsMessagePack) {
  logged.tree.tickExactlyOnce();
  const auto expected = nlohmann::json::parse(R"({"Main": {"speed": 0.5}})");
  nlohmann::json values;  // the publisher learns of the tick soon after it
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (values != expected && std::chrono::steady_clock::now() < until) {
    const Parts reply = Ask('B', "Main");
    ASSERT_EQ(reply.size(), 2U);
    values = nlohmann::json::from_msgpack(reply[1]);
  }
  EXPECT_EQ(values, expected);
}

TEST_F(Groot2, AHookTakesThePlaceOfANode) {
  const Parts reply = Ask('I', R"({"enabled": true, "uid": 3, "mode": 1, "once": false,)"
                               R"( "desired_status": "SUCCESS", "position": 0})");
  ASSERT_EQ(reply.size(), 1U);
  EXPECT_EQ(logged.tree.tickExactlyOnce(), BT::NodeStatus::SUCCESS);
}

TEST_F(Groot2, AnErrorSaysWhatIsWrong) {
  client.Send({"short"});
  EXPECT_EQ(client.Receive(), (Parts{"error", "wrong request header"}));
}

TEST_F(Groot2, TheDelayOfTheHeartbeatCanBeChanged) {
  publisher->setMaxHeartbeatDelay(std::chrono::milliseconds(700));
  EXPECT_EQ(publisher->maxHeartbeatDelay(), std::chrono::milliseconds(700));
  EXPECT_EQ(Ask('S').at(0).size(), 22U);
}

}  // namespace
