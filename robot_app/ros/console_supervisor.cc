#include "robot_app/ros/console_supervisor.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace coppice::robot {

ConsoleSupervisor::ConsoleSupervisor(ros::NodeHandle& node)
    : question_(node.advertise<std_msgs::String>("/supervisor/question", 10, true)),
      answer_(node.subscribe<std_msgs::String>(
          "/supervisor/answer", 10,
          [this](const std_msgs::String::ConstPtr& message) { Answer(message->data); })),
      reader_([this] { ReadConsole(); }) {}

ConsoleSupervisor::~ConsoleSupervisor() {
  stop_ = true;
  reader_.join();
}

void ConsoleSupervisor::Ask(const std::string& subject, const std::string& question,
                            Sender<ActionResult> done) {
  Close(subject);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    open_.push_back({subject, done});
  }
  std::cout << "\n*** The robot asks for help: " << question
            << "\n*** Answer with \"fixed\" or \"not fixed\".\n"
            << std::flush;
  std_msgs::String message;
  message.data = question;
  question_.publish(message);
}

void ConsoleSupervisor::Withdraw(const std::string& subject) {
  if (!Close(subject)) return;
  std::cout << "*** " << subject << ": the robot needs no help any more.\n" << std::flush;
}

void ConsoleSupervisor::Tell(const std::string& subject, const std::string& message) {
  std::cout << "*** " << subject << ": " << message << "\n" << std::flush;
}

// True if there was one.
bool ConsoleSupervisor::Close(const std::string& subject) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(open_.begin(), open_.end(), [&](const Request& request) {
    return request.subject == subject;
  });
  if (found == open_.end()) return false;
  open_.erase(found);
  return true;
}

void ConsoleSupervisor::Answer(const std::string& text) {
  const bool fixed = text == "fixed";
  if (!fixed && text != "not fixed") {
    std::cout << "*** \"" << text << "\" is neither \"fixed\" nor \"not fixed\".\n" << std::flush;
    return;
  }
  Sender<ActionResult> done;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (open_.empty()) return;
    done = open_.back().done;
    open_.pop_back();
  }
  done.Send({fixed, fixed ? "" : "the supervisor could not fix it"});
}

// Looks ten times a second whether to stop, so that nobody has to type for the program to end.
void ConsoleSupervisor::ReadConsole() {
  std::string line;
  while (!stop_) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 100) <= 0) continue;
    char c = 0;
    if (read(STDIN_FILENO, &c, 1) <= 0) return;  // nobody there
    if (c != '\n') {
      line += c;
    } else {
      Answer(line);
      line.clear();
    }
  }
}

}  // namespace coppice::robot
