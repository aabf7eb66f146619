#include "robot_app/perception/detection/network_detector.h"

#include <algorithm>
#include <cstdio>
#include <opencv2/dnn.hpp>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "bt_core/base/read_file.h"
#include "robot_app/perception/detection/network_classes.h"
#include "robot_app/perception/detection/network_output.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/perception/detection/suppression.h"
#include "robot_app/perception/detection/try_apart.h"

namespace coppice::robot::perception {
namespace {

constexpr std::size_t kLargestNetwork = std::size_t{1} << 30;  // bytes
constexpr int kUsualSize = 640;
constexpr int kLargestSize = 4096;
constexpr double kSameOne = 0.45;
constexpr int kGray = 114;  // beside a picture that is no square

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// How a picture lies in the square that a network takes.
struct Fitting {
  double zoom = 1;
  double left = 0, top = 0;  // pixels
};

struct Network {
  cv::dnn::Net net;
  bool is_darknet = false;
  int size = kUsualSize;
  std::vector<std::string> outputs;
};

Fitting Fit(const cv::Mat& picture, int size, cv::Mat& square) {
  Fitting fitting;
  fitting.zoom = double(size) / std::max(picture.cols, picture.rows);
  const cv::Size scaled(std::clamp(cvRound(picture.cols * fitting.zoom), 1, size),
                        std::clamp(cvRound(picture.rows * fitting.zoom), 1, size));
  const cv::Rect part((size - scaled.width) / 2, (size - scaled.height) / 2, scaled.width,
                      scaled.height);
  fitting.left = part.x;
  fitting.top = part.y;
  square.create(size, size, CV_8UC3);
  square.setTo(cv::Scalar::all(kGray));
  cv::resize(picture, square(part), scaled, 0, 0, cv::INTER_AREA);
  return fitting;
}

// The pictures of this project are red first, as the networks want them.
std::vector<cv::Mat> Run(Network& network, const cv::Mat& square) {
  network.net.setInput(cv::dnn::blobFromImage(square, 1 / 255.0));
  std::vector<cv::Mat> outputs;
  network.net.forward(outputs, network.outputs);
  return outputs;
}

std::vector<int> SizesOf(const cv::Mat& output) {
  return {output.size.p, output.size.p + output.dims};
}

class NetworkDetector : public Detector {
 public:
  NetworkDetector(Network network, const OutputForm& form, NetworkClasses classes, double least)
      : network_(std::move(network)), form_(form), classes_(std::move(classes)), least_(least) {}

  std::vector<Sighting> Find(const DetectorInput& input) override {
    const Picture& picture = input.colour;
    if (picture.width <= 0 || picture.height <= 0) return {};
    const Fitting fitting = Fit(View(picture), network_.size, square_);
    std::vector<Sighting> sightings;
    for (const cv::Mat& output : Run(network_, square_)) {
      for (const RawBox& raw : BoxesIn({SizesOf(output), output.ptr<float>()}, form_, least_)) {
        const auto kind = classes_[static_cast<std::size_t>(raw.kind)];
        if (kind) sightings.push_back({*kind, InPicture(raw, fitting), raw.confidence});
      }
    }
    return Suppress(std::move(sightings), kSameOne);
  }

  bool Finds(SightingKind kind) const override {
    return std::find(classes_.begin(), classes_.end(), kind) != classes_.end();
  }

 private:
  Box InPicture(const RawBox& raw, const Fitting& fitting) const {
    const double unit = form_.layout == OutputLayout::kDarknet ? network_.size : 1;
    const auto scaled = [&](double x, double border) { return (unit * x - border) / fitting.zoom; };
    return {scaled(raw.x - raw.width / 2, fitting.left),
            scaled(raw.y - raw.height / 2, fitting.top), scaled(raw.width, 0),
            scaled(raw.height, 0)};
  }

  Network network_;
  OutputForm form_;
  NetworkClasses classes_;
  double least_;
  cv::Mat square_;
};

// The line "width=416" of a Darknet configuration.
std::optional<int> SizeIn(const std::string& config) {
  std::istringstream lines(config);
  for (std::string line; std::getline(lines, line);) {
    int size = 0;
    if (std::sscanf(line.c_str(), " width = %5d", &size) == 1) return size;
  }
  return std::nullopt;
}

Expected<Network> ReadDarknet(const NetworkFiles& files, const std::string& weights) {
  if (files.config.empty()) {
    return Problem{files.file + ": weights of Darknet need the network's .cfg too"};
  }
  const auto config = ReadFile(files.config);
  if (!config) return Problem{files.config + ": cannot be read"};
  Network network;
  network.is_darknet = true;
  network.size = SizeIn(*config).value_or(kUsualSize);
  network.net =
      cv::dnn::readNetFromDarknet(config->data(), config->size(), weights.data(), weights.size());
  return network;
}

Expected<Network> ReadNetwork(const NetworkFiles& files) {
  const bool is_darknet = EndsWith(files.file, ".weights");
  if (!is_darknet && !EndsWith(files.file, ".onnx")) {
    return Problem{files.file + ": expected a network in a file .weights or .onnx"};
  }
  const auto text = ReadFile(files.file, kLargestNetwork);
  if (!text) return Problem{files.file + ": cannot be read"};
  if (is_darknet) return ReadDarknet(files, *text);
  Network network;
  network.net = cv::dnn::readNetFromONNX(text->data(), text->size());
  return network;
}

Expected<NetworkClasses> ClassesOf(const NetworkFiles& files, int count) {
  if (files.classes.empty()) return UsualClasses(count);
  const auto text = ReadFile(files.classes);
  if (!text) return Problem{files.classes + ": cannot be read"};
  auto classes = ParseClasses(*text);
  if (!classes) return Problem{files.classes + ": " + classes.problem()};
  if (static_cast<int>(classes->size()) != count) {
    return Problem{files.classes + ": names " + std::to_string(classes->size()) +
                   " classes, and the network has " + std::to_string(count)};
  }
  return classes;
}

Expected<std::unique_ptr<Detector>> Make(const NetworkFiles& files, double least_confidence) {
  auto network = ReadNetwork(files);
  if (!network) return Problem{network.problem()};
  if (files.size > 0) network->size = files.size;
  if (network->net.empty() || network->size > kLargestSize) {
    return Problem{files.file + ": expected a network for pictures of up to 4096 x 4096 pixels"};
  }
  network->outputs = network->net.getUnconnectedOutLayersNames();
  const cv::Mat empty(network->size, network->size, CV_8UC3, cv::Scalar::all(kGray));
  const std::vector<cv::Mat> outputs = Run(*network, empty);
  std::optional<OutputForm> form;
  for (const cv::Mat& output : outputs) {
    if (output.depth() != CV_32F) return Problem{files.file + ": expected outputs of floats"};
    const auto found = FormOf(SizesOf(output), network->is_darknet);
    if (!found) return Problem{files.file + ": " + found.problem()};
    if (form && (form->layout != found->layout || form->classes != found->classes)) {
      return Problem{files.file + ": its outputs have different numbers of classes"};
    }
    form = *found;
  }
  if (!form) return Problem{files.file + ": the network has no output"};
  auto classes = ClassesOf(files, form->classes);
  if (!classes) return Problem{classes.problem()};
  return std::unique_ptr<Detector>(std::make_unique<NetworkDetector>(
      std::move(*network), *form, std::move(*classes), least_confidence));
}

// OpenCV's own text without the place in its sources, if it is one of OpenCV's.
std::string Reason(const std::exception& error) {
  const auto* const of_opencv = dynamic_cast<const cv::Exception*>(&error);
  const std::string text = of_opencv != nullptr ? of_opencv->err : error.what();
  return text.substr(0, text.find('\n'));
}

Problem NotRun(const NetworkFiles& files, const std::string& reason) {
  return Problem{files.file + ": OpenCV cannot run it (" + reason +
                 "); expected YOLOv3 of Darknet, or ONNX for pictures of " +
                 std::to_string(files.size > 0 ? files.size : kUsualSize) + " pixels"};
}

Expected<std::unique_ptr<Detector>> MakeHere(const NetworkFiles& files, double least_confidence) {
  try {
    return Make(files, least_confidence);
  } catch (const std::exception& error) {
    return NotRun(files, Reason(error));
  }
}

}  // namespace

Expected<std::unique_ptr<Detector>> MakeNetworkDetector(const NetworkFiles& files,
                                                        double least_confidence) {
  const Expected<int> tried = TryApart([&] { return MakeHere(files, least_confidence) ? 0 : 1; });
  if (!tried) return NotRun(files, "it " + tried.problem());
  return MakeHere(files, least_confidence);
}

}  // namespace coppice::robot::perception
