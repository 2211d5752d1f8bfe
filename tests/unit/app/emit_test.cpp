#include "app/sweep/emit.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

#include "tests/unit/app/folder.h"

namespace scree::app::emit_test {
namespace {

Workflow example() {
  return {{"/usr/bin/scree", "sweep", "/work/it's/case.toml", "--param", "a=[1, 2],\"x {y}\"", "--quiet"},
          "/work/out {1}",
          "Sweep of\na case",
          64,
          2,
          3};
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string printed(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string out;
  std::array<char, 256> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) out += buffer.data();
  return out;
}

TEST(ShellWord, shell_reads_back_any_text) {
  for (const std::string text : {"plain", "", "two words", "it's", "$HOME `x` \"y\" \\", "a=[1, 2];*?{}"})
    EXPECT_EQ(printed("printf '<%s>' " + shell_word(text)), "<" + text + ">");
  EXPECT_EQ(shell_words({"a=1", "b c"}), "a=1 'b c'");
}

TEST(ArrayText, joins_neighbours) {
  EXPECT_EQ(array_text({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(array_text({5}), "5");
}

TEST(SnakemakeWorkflow, names_every_run_and_quotes_paths) {
  const std::string text = snakemake_workflow(example());
  EXPECT_TRUE(holds(text, "for n in range(1, 65)")) << text;
  EXPECT_TRUE(holds(text, "{n:04d}")) << text;
  EXPECT_TRUE(holds(text, "workdir: \"/work/out {1}\"")) << text;
  EXPECT_TRUE(holds(text, R"('/work/it'\\''s/case.toml')")) << text;
  EXPECT_TRUE(holds(text, "threads: 3")) << text;
  EXPECT_TRUE(holds(text, "\"{params.command} --only {wildcards.run}\"")) << text;
  EXPECT_TRUE(holds(text, "# Sweep of\\na case: 64 runs")) << text;
}

TEST(SnakemakeWorkflow, python_reads_the_command_back) {
  const Folder folder;
  const std::string text = snakemake_workflow(example());
  const std::size_t from = text.find("COMMAND = ");
  folder.put("part.py",
             "import shlex\n" + text.substr(from, text.find("\nRUNS") - from) + "\nprint(shlex.split(COMMAND))\n");
  EXPECT_EQ(printed("python3 " + (folder.path() / "part.py").string()),
            "['/usr/bin/scree', 'sweep', \"/work/it's/case.toml\", '--param', 'a=[1, 2],\"x {y}\"', '--quiet']\n");
}

TEST(GnuParallelScript, makes_one_run_for_an_argument) {
  Workflow w = example();
  w.command = {"echo", "two words", "it's"};
  const Folder folder;
  folder.put("jobs.sh", gnu_parallel_script(w));
  EXPECT_EQ(printed("sh " + (folder.path() / "jobs.sh").string() + " 17"), "two words it's --only 17\n");
}

TEST(GnuParallelScript, hands_over_all_numbers_and_collects) {
  Workflow w = example();
  w.command = {"echo", "made"};
  w.runs = 3;
  const Folder folder;
  // Stands in for GNU parallel: one run after the other.
  folder.put("parallel", "#!/bin/sh\nshift 3\nscript=$2\nwhile read -r n; do sh \"$script\" \"$n\"; done\n");
  folder.put("jobs.sh", gnu_parallel_script(w));
  const std::string path = folder.path().string();
  EXPECT_EQ(printed("chmod +x " + path + "/parallel; PATH=" + path + ":$PATH sh " + path + "/jobs.sh"),
            "made --only 1\nmade --only 2\nmade --only 3\nmade --collect\n");
}

TEST(SlurmScript, asks_for_an_array_of_the_runs) {
  const std::string text = slurm_script(example(), "1-64");
  EXPECT_TRUE(text.starts_with("#!/bin/sh\n")) << text;
  EXPECT_TRUE(holds(text, "#SBATCH --array=1-64%2\n")) << text;
  EXPECT_TRUE(holds(text, "#SBATCH --cpus-per-task=3\n")) << text;
  EXPECT_TRUE(holds(text, "#SBATCH --output='/work/out {1}/logs/slurm-%a.log'\n")) << text;
  EXPECT_TRUE(holds(text, "exec /usr/bin/scree sweep ")) << text;
  Workflow unlimited = example();
  unlimited.jobs = 0;
  EXPECT_TRUE(holds(slurm_script(unlimited, "2,4"), "#SBATCH --array=2,4\n"));
}

}  // namespace
}  // namespace scree::app::emit_test
