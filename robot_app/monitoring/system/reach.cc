#include "robot_app/monitoring/system/reach.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "robot_app/monitoring/system/sockets.h"

namespace coppice::robot::monitoring {
namespace {

using SteadyClock = std::chrono::steady_clock;

struct Attempt {
  Socket socket;
  SteadyClock::time_point begun = SteadyClock::now();
  bool is_done = false;
};

ReachDelay Conclude(Attempt& attempt) {
  int code = 0;
  socklen_t size = sizeof(code);
  getsockopt(attempt.socket.fd(), SOL_SOCKET, SO_ERROR, &code, &size);
  attempt.is_done = true;
  if (code != 0 && code != ECONNREFUSED) return Problem{std::strerror(code)};
  return std::chrono::duration<double>(SteadyClock::now() - attempt.begun).count();
}

Attempt Begin(const ReachTarget& target, ReachDelay& result) {
  Attempt attempt;
  Expected<Socket> socket = Connect(target.address, target.port, SOCK_STREAM);
  attempt.is_done = !socket;
  if (socket) {
    attempt.socket = *std::move(socket);
  } else {
    result = Problem{socket.problem()};
  }
  return attempt;
}

}  // namespace

std::vector<ReachDelay> TryToReach(const std::vector<ReachTarget>& targets, Duration deadline) {
  std::vector<ReachDelay> results(targets.size(), Problem{"no answer"});
  std::vector<Attempt> attempts;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    attempts.push_back(Begin(targets[i], results[i]));
  }
  const Deadline until(deadline);
  do {
    std::vector<pollfd> waiting;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      if (attempts[i].is_done) continue;
      waiting.push_back({attempts[i].socket.fd(), POLLOUT, 0});
      indices.push_back(i);
    }
    if (waiting.empty()) break;
    poll(waiting.data(), waiting.size(), until.milliseconds());
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].revents != 0) results[indices[i]] = Conclude(attempts[indices[i]]);
    }
  } while (!until.has_passed());
  return results;
}

}  // namespace coppice::robot::monitoring
