// The plainest use of a WebPort: a page of one file.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_FILE_CONNECTION_H_
#define COPPICE_TESTS_BT_CORE_LIVE_FILE_CONNECTION_H_

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "bt_core/live/web/web_connection.h"
#include "tests/support/temporary_folder.h"

namespace coppice {

class FileConnection : public WebConnection {
 public:
  using WebConnection::WebConnection;

 private:
  void OnUpgrade() override { Refuse(Status::forbidden, "not here\n"); }
};

class FilePort {
 public:
  explicit FilePort(const std::string& address = "127.0.0.1", std::uint16_t port = 0,
                    std::size_t most_connections = 64)
      : port_({address, port, "file_port", most_connections}, [this](WebPort::Socket socket,
                                                                     WebPort& web_port) {
          return std::make_shared<FileConnection>(std::move(socket), web_port, files_, options_);
        }) {
    Write("index.html", "<p>hello</p>");
  }
  ~FilePort() { port_.Stop(); }
  FilePort(const FilePort&) = delete;
  FilePort& operator=(const FilePort&) = delete;

  void Write(const std::string& name, const std::string& text) const {
    WriteFile(folder_.Path(name), text);
  }
  std::string Path(const std::string& name) const { return folder_.Path(name); }
  std::uint16_t port() const { return port_.port(); }
  void Stop() { port_.Stop(); }

 private:
  const TemporaryFolder folder_;
  const WebFiles files_{folder_.path()};
  const WebConnectionOptions options_{1 << 10, 16, {{"X-Test", "yes"}}, "no such thing\n"};
  WebPort port_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_FILE_CONNECTION_H_
