#include <atomic>

#include "bt_core/live/web/web_gateway.h"
#include "tests/bt_core/live/web_caller.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

// A gateway that says back what it was told.
class Echo {
 public:
  std::uint16_t port() const { return gateway_.port(); }
  int heard() const { return heard_; }

 private:
  static WebGatewayOptions Options() {
    WebGatewayOptions options;
    options.address = "127.0.0.1";
    options.folder = ".";
    return options;
  }
  void Answer() {
    ReceivedRequest request;
    while (clients_.Receive(request)) {
      if (clients_.Send(request.client, request.parts) != SendResult::kGone) ++heard_;
    }
  }

  std::atomic<int> heard_{0};
  LiveClients clients_{[this] { Answer(); }};
  WebGateway gateway_{Options(), clients_};
};

}  // namespace

int FuzzWeb(std::string_view bytes) {
  static Echo echo;
  const int heard = echo.heard();
  WebCaller caller(echo.port());
  const bool is_open = !bytes.empty() && bytes[0] == 'W';
  if (is_open) {
    caller.Upgrade("");
    bytes.remove_prefix(1);
  }
  caller.Say(std::string(bytes));
  const std::string answer = caller.Rest();
  if (echo.heard() > heard) return 3;
  return is_open ? 2 : !answer.empty();
}

}  // namespace coppice::fuzz
