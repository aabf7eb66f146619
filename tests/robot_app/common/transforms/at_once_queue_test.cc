#include "robot_app/common/transforms/at_once_queue.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <thread>

namespace coppice::robot {
namespace {

class Note : public ros::CallbackInterface {
 public:
  CallResult call() override {
    called_by = std::this_thread::get_id();
    return Success;
  }
  std::thread::id called_by;
};

TEST(AtOnceQueue, WhatComesIsHandledByTheThreadThatBringsIt) {
  AtOnceQueue queue;
  const auto note = boost::make_shared<Note>();
  std::thread reader([&] { queue.addCallback(note, 1); });
  const std::thread::id id = reader.get_id();
  reader.join();
  EXPECT_EQ(note->called_by, id);
  queue.removeByID(1);
}

}  // namespace
}  // namespace coppice::robot
