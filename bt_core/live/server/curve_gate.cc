#include "bt_core/live/server/curve_gate.h"

#include <string>
#include <utility>
#include <vector>

namespace coppice {

CurveGate::CurveGate(zmq::context_t& context, RobotKeys keys)
    : keys_(std::move(keys)), socket_(context, zmq::socket_type::rep) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.bind("inproc://zeromq.zap.01");
}

void CurveGate::Guard(zmq::socket_t& socket) const {
  socket.set(zmq::sockopt::curve_server, true);
  socket.set(zmq::sockopt::curve_secretkey, keys_.robot.secret_key);
  socket.set(zmq::sockopt::zap_domain, "coppice");
}

const char* CurveGate::RoleOf(const std::string& public_key) const {
  if (public_key == keys_.control_client) return kControl;
  if (public_key == keys_.read_client) return kRead;
  return nullptr;
}

// Request: version, number, domain, address, identity, mechanism, public key.
// Reply: version, number, code, text, user, metadata.
void CurveGate::Serve() {
  std::vector<std::string> request;
  zmq::message_t part;
  while (socket_.recv(part, zmq::recv_flags::dontwait)) {
    request.push_back(part.to_string());
    if (part.more()) continue;
    const bool is_curve = request.size() == 7 && request[5] == "CURVE";
    const char* const role = is_curve ? RoleOf(request[6]) : nullptr;
    const std::string reply[] = {"1.0",
                                 request.size() > 1 ? request[1] : "",
                                 role ? "200" : "400",
                                 role ? "OK" : "this key follows from no token of this robot",
                                 role ? role : "",
                                 ""};
    for (const std::string& text : reply) {
      const bool last = &text == std::end(reply) - 1;
      socket_.send(zmq::buffer(text), last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
    request.clear();
  }
}

}  // namespace coppice
