#include "fingerpad/view.hpp"

#include "base/output_place.hpp"
#include "trace/trace.hpp"
#include "view/picture.hpp"
#include "view/plot.hpp"
#include "view/screen.hpp"
#include "view/window.hpp"

namespace fingerpad {
namespace {

ViewInput input_of(const std::string& trace_path) {
  return view_of_trace(read_trace(trace_path), trace_path);
}

}  // namespace

void draw_trace(const std::string& trace_path, const std::string& png_path, const PictureOptions& options) {
  refuse_picture_size(options.width, options.height);
  refuse_unwritable(png_path);
  write_view_png(input_of(trace_path), png_path, options.width, options.height, options.at_s, ViewState());
}

void plot_trace(const std::string& trace_path, const std::string& picture_path) {
  refuse_unwritable(picture_path);
  write_plot(input_of(trace_path), picture_path, plot_page_width);
}

void show_trace(const std::string& trace_path) {
  need_display("call draw_trace() instead");
  run_view_window(input_of(trace_path), WindowOptions{});
}

}  // namespace fingerpad
