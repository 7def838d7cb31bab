#pragma once

#include <string>
#include <string_view>

#include "view/pixels.hpp"

namespace fingerpad {

/// What turns frames into a movie: Debian's ffmpeg, as a process of its own that is fed with pixels. The
/// movie is written to a file in memory, so that a disk that is full, or half a movie, is OutputFile's
/// matter.
class MovieEncoder {
 public:
  /// @param path  of the movie; its ending says which kind it is
  /// Throws Error (usage) where ffmpeg is not installed, and (fault) where it does not start.
  MovieEncoder(const std::string& path, int width, int height, double frames_per_s);
  /// Ends the process if finish() was not reached.
  ~MovieEncoder();
  MovieEncoder(const MovieEncoder&) = delete;
  MovieEncoder& operator=(const MovieEncoder&) = delete;

  /// The next frame. Throws Error (fault) where ffmpeg has ended, with what it said.
  void add(const Pixels& frame);

  /// Writes the movie to its path. Throws as add does, and as OutputFile does.
  void finish();

  /// The kinds of movies: endings with their dots.
  static constexpr std::string_view endings[] = {".mp4", ".ogv"};

 private:
  [[noreturn]] void fail();
  int wait_for_end();

  std::string path_, program_;
  int process_ = -1;
  int frames_ = -1;              ///< the socket to its standard input
  int movie_ = -1, words_ = -1;  ///< files in memory: what it writes, what it says
};

/// Throws Error (usage) where ffmpeg is not installed: asked before long work.
void need_movie_encoder();

}  // namespace fingerpad
