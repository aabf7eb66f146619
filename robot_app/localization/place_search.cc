#include "robot_app/localization/place_search.h"

#include <algorithm>
#include <cmath>

#include "robot_app/localization/scan_matcher.h"

namespace coppice::robot::localization {
namespace {

constexpr double kCell = 0.1;        // m
constexpr int kLevels = 5;           // squares of 1, 2, ... 16 cells
constexpr int kHeadings = 120;       // of a full turn
constexpr double kFarthest = 10;     // farther ends move too much within one heading [m]
constexpr std::size_t kEnds = 60;    // enough to tell places apart coarsely
constexpr double kNoise = 0.15;      // m
constexpr double kWorst = 0.45;      // a coarse score below is no candidate
constexpr double kBehindBest = 0.2;  // nor is one that is so much worse than the best
constexpr int kMargin = static_cast<int>((kFarthest + 0.5) / kCell);  // unknown cells around

}  // namespace

struct PlaceSearch::Node {
  int turn = 0;
  int level = 0;
  int column = 0;
  int row = 0;
  double score = 0;

  static bool IsWorse(const Node& a, const Node& b) { return a.score < b.score; }
  static bool IsBetter(const Node& a, const Node& b) { return a.score > b.score; }
};

// The beams' ends at one heading, as steps in the arrays of the levels.
struct PlaceSearch::Turned {
  double yaw = 0;
  std::vector<std::int32_t> steps;
};

bool IsSamePlace(const Pose2D& a, const Pose2D& b) {
  return Distance(a, b) < kSamePlace && std::abs(NormalizeAngle(a.yaw - b.yaw)) < kSameHeading;
}

PlaceSearch::PlaceSearch(const LikelihoodField& field) : field_(field) { Build(); }

void PlaceSearch::Build() {
  const GridFrame& frame = field_.frame();
  width_ = static_cast<int>(std::ceil(frame.width * frame.resolution / kCell)) + 2 * kMargin;
  height_ = static_cast<int>(std::ceil(frame.height * frame.resolution / kCell)) + 2 * kMargin;
  const std::size_t size = static_cast<std::size_t>(width_) * height_;
  best_.assign(kLevels, std::vector<std::uint8_t>(size));
  free_ = best_;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const double x = frame.origin_x + (column - kMargin + 0.5) * kCell;
      const double y = frame.origin_y + (row - kMargin + 0.5) * kCell;
      const double off = field_.Distance(x, y) / kNoise;
      const std::size_t i = static_cast<std::size_t>(row) * width_ + column;
      best_[0][i] = static_cast<std::uint8_t>(std::lround(255 * std::exp(-off * off / 2)));
      free_[0][i] = field_.Free(x, y) ? 1 : 0;
    }
  }
  for (int level = 1; level < kLevels; ++level) {
    const int step = 1 << (level - 1);
    for (auto* values : {&best_, &free_}) {
      const std::vector<std::uint8_t>& fine = (*values)[level - 1];
      std::vector<std::uint8_t>& coarse = (*values)[level];
      for (int row = 0; row < height_; ++row) {
        for (int column = 0; column < width_; ++column) {
          const int right = std::min(column + step, width_ - 1);
          const std::size_t here = static_cast<std::size_t>(row) * width_;
          const std::size_t above =
              static_cast<std::size_t>(std::min(row + step, height_ - 1)) * width_;
          coarse[here + column] = std::max(
              {fine[here + column], fine[here + right], fine[above + column], fine[above + right]});
        }
      }
    }
  }
}

double PlaceSearch::Bound(const Turned& turned, int level, int column, int row) const {
  const std::uint8_t* base =
      best_[level].data() + static_cast<std::ptrdiff_t>(row) * width_ + column;
  int sum = 0;
  for (const std::int32_t step : turned.steps) sum += base[step];
  return sum / (255.0 * static_cast<double>(turned.steps.size()));
}

std::vector<PlaceSearch::Node> PlaceSearch::Coarse(const std::vector<Turned>& turns) const {
  constexpr int kTop = kLevels - 1;
  std::vector<Node> nodes;
  for (int row = kMargin; row < height_ - kMargin; row += 1 << kTop) {
    for (int column = kMargin; column < width_ - kMargin; column += 1 << kTop) {
      if (free_[kTop][static_cast<std::size_t>(row) * width_ + column] == 0) continue;
      for (int turn = 0; turn < static_cast<int>(turns.size()); ++turn) {
        const double bound = Bound(turns[turn], kTop, column, row);
        if (bound >= kWorst) nodes.push_back({turn, kTop, column, row, bound});
      }
    }
  }
  std::make_heap(nodes.begin(), nodes.end(), Node::IsWorse);
  return nodes;
}

void PlaceSearch::Descend(const Turned& turned, const Node& node, double& threshold,
                          std::vector<Node>& found) const {
  if (node.score < threshold) return;
  if (node.level == 0) {
    found.push_back(node);
    threshold = std::max(threshold, node.score - kBehindBest);
    return;
  }
  const int level = node.level - 1;
  const int step = 1 << level;
  std::vector<Node> parts;
  for (const int up : {0, step}) {
    for (const int right : {0, step}) {
      const Node part{node.turn, level, node.column + right, node.row + up, 0};
      if (part.column >= width_ - kMargin || part.row >= height_ - kMargin) continue;
      if (free_[level][static_cast<std::size_t>(part.row) * width_ + part.column] == 0) continue;
      parts.push_back(part);
      parts.back().score = Bound(turned, level, part.column, part.row);
    }
  }
  std::sort(parts.begin(), parts.end(), Node::IsBetter);
  for (const Node& part : parts) Descend(turned, part, threshold, found);
}

std::vector<FittingPlace> PlaceSearch::Find(const std::vector<Beam>& beams,
                                            std::size_t most) const {
  std::vector<Point2D> ends;
  for (const Beam& beam : beams) {
    if (beam.hit && std::hypot(beam.to.x, beam.to.y) < kFarthest) ends.push_back(beam.to);
  }
  if (ends.size() < kEnds / 3) return {};
  const double every = std::max(1.0, static_cast<double>(ends.size()) / kEnds);
  std::vector<Turned> turns(kHeadings);
  for (int i = 0; i < kHeadings; ++i) {
    turns[i].yaw = NormalizeAngle(2 * M_PI * i / kHeadings);
    const PointComposer turned({0, 0, turns[i].yaw});
    for (double j = 0; j < static_cast<double>(ends.size()); j += every) {
      const Point2D end = turned(ends[static_cast<std::size_t>(j)]);
      turns[i].steps.push_back(static_cast<int>(std::lround(end.y / kCell)) * width_ +
                               static_cast<int>(std::lround(end.x / kCell)));
    }
  }
  std::vector<Node> found;
  double threshold = kWorst;
  // The best first: most of the others are below what these have found.
  std::vector<Node> nodes = Coarse(turns);
  while (!nodes.empty() && nodes.front().score >= threshold) {
    const Node node = nodes.front();
    std::pop_heap(nodes.begin(), nodes.end(), Node::IsWorse);
    nodes.pop_back();
    Descend(turns[node.turn], node, threshold, found);
  }
  std::sort(found.begin(), found.end(), Node::IsBetter);

  const GridFrame& frame = field_.frame();
  std::vector<Pose2D> peaks;
  std::vector<FittingPlace> places;
  const auto is_known = [](const std::vector<Pose2D>& poses, const Pose2D& pose) {
    return std::any_of(poses.begin(), poses.end(),
                       [&](const Pose2D& other) { return IsSamePlace(other, pose); });
  };
  for (const Node& node : found) {
    if (node.score < threshold || peaks.size() >= 2 * most) break;
    const Pose2D pose{frame.origin_x + (node.column - kMargin + 0.5) * kCell,
                      frame.origin_y + (node.row - kMargin + 0.5) * kCell, turns[node.turn].yaw};
    if (is_known(peaks, pose)) continue;
    peaks.push_back(pose);
    const Pose2D matched = MatchScan(field_, beams, pose);
    places.push_back({matched, Agree(field_, beams, matched)});
  }
  std::sort(places.begin(), places.end(), [](const FittingPlace& a, const FittingPlace& b) {
    return a.agreement.share() > b.agreement.share();
  });
  std::vector<FittingPlace> distinct;
  for (const FittingPlace& place : places) {
    const bool known =
        std::any_of(distinct.begin(), distinct.end(),
                    [&](const FittingPlace& other) { return IsSamePlace(other.pose, place.pose); });
    if (!known && distinct.size() < most) distinct.push_back(place);
  }
  return distinct;
}

}  // namespace coppice::robot::localization
