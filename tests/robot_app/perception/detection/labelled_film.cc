#include "tests/robot_app/perception/detection/labelled_film.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <string>

#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

// By the number of the frame.
std::map<int, std::vector<Sighting>> ReadLabels() {
  const std::string file =
      SourceFolder() + "/tests/robot_app/perception/detection/vtest_people.csv";
  std::ifstream lines(file);
  std::map<int, std::vector<Sighting>> labels;
  for (std::string line; std::getline(lines, line);) {
    int frame = 0, counts = 0;
    Box box;
    if (std::sscanf(line.c_str(), "%d,%lf,%lf,%lf,%lf,%d", &frame, &box.x, &box.y, &box.width,
                    &box.height, &counts) == 6) {
      labels[frame].push_back({SightingKind::kPerson, box, double(counts)});
    }
  }
  if (labels.empty()) throw std::runtime_error(file + ": no labels");
  return labels;
}

Picture ToPicture(const cv::Mat& bgr) {
  Picture picture(bgr.cols, bgr.rows);
  cv::Mat rgb(bgr.rows, bgr.cols, CV_8UC3, picture.rgb.data());
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  return picture;
}

}  // namespace

bool ShowFilm(int step, const std::function<void(const LabelledFrame&)>& show) {
  if (!std::ifstream(kFilm)) return false;
  cv::VideoCapture film(kFilm);
  if (!film.isOpened()) throw std::runtime_error(std::string(kFilm) + ": cannot be decoded");
  int number = 0, labelled = 0;
  for (const auto& [wanted, people] : ReadLabels()) {
    for (; number <= wanted; ++number) {
      if (!film.grab()) throw std::runtime_error(std::string(kFilm) + ": ends too early");
    }
    if (labelled++ % step != 0) continue;
    cv::Mat frame;
    film.retrieve(frame);
    show({wanted, ToPicture(frame), people});
  }
  return true;
}

}  // namespace coppice::robot::perception
