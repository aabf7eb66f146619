#include "bt_core/cli/live/live_view.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include "bt_core/live/server/live_publisher.h"
#include "bt_core/live/server/token_keys.h"

namespace coppice {
namespace {

// Of an installed program ../share/coppice/web, else that of the build.
std::string WebFolder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      program.parent_path().parent_path() / "share" / "coppice" / "web";
  const bool is_there = !error && std::filesystem::exists(installed / "index.html", error);
  return is_there ? installed.string() : COPPICE_WEB_FOLDER;
}

LiveOptions ReadLiveOptions(const Options& options) {
  LiveOptions live;
  live.port = static_cast<std::uint16_t>(options.Whole("--live-port", live.port));
  live.address = options.Get("--live-address", live.address);
  live.announce = options.Has("--announce");
  live.read_only = options.Has("--live-read-only");
  live.wait_for_client = std::chrono::seconds(options.Whole("--wait-for-client", 0));
  live.web = options.Has("--web") || options.Has("--web-port") || options.Has("--web-folder");
  live.web_port = static_cast<std::uint16_t>(options.Whole("--web-port", live.web_port));
  live.web_folder = options.Get("--web-folder", WebFolder());
  if (const char* token = std::getenv(kTokenVariable)) live.token = token;
  return live;
}

// Behind the '#' nothing is sent to the robot but by the page itself.
std::string Link(const LiveOptions& live, std::uint16_t port, const std::string& token,
                 const char* scheme) {
  const std::string host = live.address == "*" || live.address == "lo" ? "localhost" : live.address;
  return std::string(scheme) + "://" + host + ":" + std::to_string(port) + "/" +
         (token.empty() ? "" : "#" + token);
}

void PrintWeb(const LiveOptions& live, const LiveWeb& web) {
  if (web.port == 0) return;
  std::error_code error;
  const bool has_page = std::filesystem::exists(live.web_folder + "/index.html", error);
  const char* const scheme = has_page ? "http" : "ws";
  if (!has_page) {
    std::cerr << "no page for browsers: there is no index.html in \"" << live.web_folder
              << "\" (a build with -DCOPPICE_WEB=ON makes it, --web-folder says where it is)\n";
  }
  std::cerr << (has_page ? "in a browser: " : "for clients of the WebSocket: ")
            << Link(live, web.port, web.control_token, scheme) << "\n";
  if (web.read_token.empty()) return;
  std::cerr << "for those who only watch: " << Link(live, web.port, web.read_token, scheme) << "\n";
}

}  // namespace

LiveView::LiveView(EventStream& stream, const Options& options,
                   std::function<void(const HistoryNote&)> on_note) {
  if (!WantsLiveView(options)) return;
  LiveOptions live = ReadLiveOptions(options);
  live.on_note = std::move(on_note);
  publisher_ = std::make_unique<LivePublisher>(stream, live);
  std::cerr << "live view on " << live.address << ":" << publisher_->port();
  if (live.wait_for_client > Duration::zero()) std::cerr << ", waiting for a client to continue";
  std::cerr << (live.announce ? ", announced to the network\n" : "\n");
  const std::string& read_token = publisher_->read_token();
  if (!read_token.empty()) std::cerr << "token for those who only watch: " << read_token << "\n";
  PrintWeb(live, publisher_->web());
}

LiveView::~LiveView() = default;

}  // namespace coppice
