#include "replay/merge.hpp"

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/output_name.hpp"
#include "app/standard_streams.hpp"
#include "base/count_words.hpp"

namespace fingerpad {

void add_merge(CLI::App& program, Action& action) {
  struct MergeOptions {
    std::vector<std::string> folders;
    std::string out;
    bool quiet = false;
  };
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      program.add_subcommand("merge", "Put the shards of a batch together as one run would have written it");
  command
      ->add_option("DIR", options->folders, "Folders that `replay --shard K/N` wrote: all shards of a batch")
      ->required();
  refuse_empty(command->add_option("--out", options->out, "Folder for the whole; may be one of them"),
               "FOLDER")
      ->required();
  add_quiet_flag(*command, options->quiet);
  command->footer("Traces, summary.csv and jobs.csv are byte for byte those of a single run.");
  command->callback([options, &action] {
    action = [options] {
      const MergedShards merged = merge_shards(options->folders, options->out);
      if (!options->quiet)
        print_out("{}: {}, {} and summary.csv in {}\n",
                  count_words(static_cast<std::size_t>(merged.shards), "shard"),
                  count_words(merged.jobs, "job"), count_words(merged.traces, "trace"), options->out);
      return 0;
    };
  });
}

}  // namespace fingerpad
