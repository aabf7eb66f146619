// The page /metrics of a robot, for Prometheus.
//
//   MetricsPage page({"127.0.0.1", 9467, ""}, [&] { return table.Text(); });
//
// From other computers it is read with a token only (Authorization: Bearer TOKEN).
#ifndef COPPICE_ROBOT_APP_METRICS_METRICS_PAGE_H_
#define COPPICE_ROBOT_APP_METRICS_METRICS_PAGE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace coppice::robot::metrics {

struct MetricsPageOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0 takes a free one
  std::string token;       ///< empty: none is needed, and only this computer is served
};

class MetricsPage {
 public:
  /// `text` is called by the page's thread. Throws std::runtime_error, with a text for people, if
  /// the port cannot be had, or without a token on an address that others can reach.
  MetricsPage(const MetricsPageOptions& options, std::function<std::string()> text);
  ~MetricsPage();

  std::uint16_t port() const;

 private:
  struct Server;
  std::unique_ptr<Server> server_;
};

}  // namespace coppice::robot::metrics

#endif  // COPPICE_ROBOT_APP_METRICS_METRICS_PAGE_H_
