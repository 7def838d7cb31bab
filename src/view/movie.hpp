#pragma once

#include <functional>
#include <string>

#include "view/view_input.hpp"
#include "view/view_state.hpp"

namespace fingerpad {

/// How a trace becomes a movie: frame k shows the row nearest to t_first + k * speed / frames_per_s.
struct MovieChoice {
  int width = 1280, height = 800;  ///< even [px]
  double frames_per_s = 30;
  double speed = 1;  ///< seconds of the trace in a second of the movie
};

/// Throws Error (usage) for sizes, rates and speeds that no movie can have.
void refuse_movie_choice(const MovieChoice& choice);

/// How many frames a movie has; 0 without rows. Throws Error (usage) where they are too many.
long movie_frames(const ViewInput& input, const MovieChoice& choice);

/// The row that frame k shows.
std::size_t movie_row(const ViewInput& input, const MovieChoice& choice, long k);

/// Writes a movie of what the window would show, by ffmpeg, as MP4 or Ogg by the path's ending; needs no
/// screen, as write_view_png does not.
/// @param progress  told the frames done
/// @pre input has rows
/// Throws Error as refuse_movie_choice, MovieEncoder and screen_to_draw_on do.
void write_view_movie(const ViewInput& input, const std::string& path, const MovieChoice& choice,
                      const ViewState& state, const std::function<void(long done)>& progress);

}  // namespace fingerpad
