/* The table of commands, their options, and examples.  A new option is one row here, and its reading in the
 * command's own file. */
#include "app/help.h"

/* clang-format off */
#define FOLDER(words) {.flag = "-o", .value = "DIR", .kind = VALUE_FOLDER, .about = words}
#define THREADS(words) {.flag = "--threads", .value = "N", .about = words}
#define QUIET {.flag = "--quiet", .about = "no progress"}
#define LAW {.value = "ID", .kind = VALUE_LAW, .required = true, \
             .about = "a law on the search path, or FILE.so, or FILE.so#ID"}

#define WHERE_LAWS_ARE \
  "Laws are looked for in the folders of MLAW_PLUGIN_PATH (separated by colons), then in those of the " \
  "program."

const HelpPage HELP_PAGES[] = {
    {.name = "",
     .about = "computes how a microcapsule deforms, is damaged and ruptures in a viscous flow",
     .options = {{.value = "COMMAND", .kind = VALUE_COMMAND, .required = true,
                  .about = "one of the commands below"},
                 {.value = "ARGUMENTS", .kind = VALUE_COMMAND_2, .repeats = true,
                  .about = "what the command takes"},
                 {.flag = "--help", .about = "this text; behind a command, what that takes"},
                 {.flag = "--version", .about = "the version"}},
     .text = "Exit code: 0 done, 1 the computation failed, 2 the input is wrong.",
     .examples = {{"capsella run configs/shear_quick.yaml", "a capsule in shear flow, in a few seconds"},
                  {"capsella help run", "what a run takes"}}},

    {.name = "run",
     .about = "run a scene: deformation, damage and rupture of a capsule",
     .options = {{.value = "SCENE.yaml", .kind = VALUE_YAML, .required = true,
                  .about = "the scene; `capsella manual` prints all its keys"},
                 FOLDER("where results go (default: results/NAME, NAME from the scene)"),
                 {.flag = "--set", .value = "KEY=VALUE", .kind = VALUE_SETTING, .repeats = true,
                  .about = "replace a value of the scene; without a value, remove the key"},
                 {.flag = "--resume",
                  .about = "go on from the newest snapshot in DIR; anew, with a warning, if it has none"},
                 {.flag = "--dry-run", .about = "check everything, estimate cost and memory, write nothing"},
                 THREADS("number of threads (default: all cores); results do not depend on it"),
                 {.flag = "--law-timeout", .value = "S",
                  .about = "end a run whose law does not come back for S seconds (default: 60; 0: wait)"},
                 QUIET},
     .text = "Ctrl-C stops after the current step and leaves a snapshot to resume from.\n"
             "Exit code: 0 done (end, steady or rupture), 1 the computation failed, 2 the input is wrong.",
     .examples = {{"capsella run configs/shear_reference.yaml", "results go to results/shear_reference"},
                  {"capsella run scene.yaml --set flow.capillary_number=0.8 -o results/Ca_0.8",
                   "the same scene in a stronger flow"},
                  {"capsella run scene.yaml --dry-run", "is it right, and how long will it take?"},
                  {"capsella run scene.yaml -o results/Ca_0.8 --resume --set time.end=20",
                   "a run that was stopped, or is to go on longer"},
                  {"capsella run scene.yaml --set membrane.damage=", "without damage"}}},

    {.name = "study",
     .about = "run many scenes: vary keys, find critical values, compare criteria",
     .options = {{.value = "STUDY.yaml", .kind = VALUE_YAML, .required = true, .about = "the study"},
                 FOLDER("where results go (default: results/NAME, NAME of the study)"),
                 {.flag = "--jobs", .value = "N",
                  .about = "cases side by side (default: one for each processor; under MPI one)"},
                 {.flag = "--resume", .about = "take over the cases that DIR holds already"},
                 {.flag = "--set", .value = "KEY=VALUE", .kind = VALUE_SETTING, .repeats = true,
                  .about = "replace a value of the study's scene"},
                 {.flag = "--part", .value = "I/N",
                  .about = "the part I of N of the values of the first varied key, in DIR/part_I"},
                 {.flag = "--dry-run", .about = "check every combination, compute nothing"},
                 THREADS("threads of each case (default: 1)"),
                 QUIET},
     .text = "Under MPI (mpirun -n 4 capsella study ...) the cases are spread over the ranks, --jobs on "
             "each.\n"
             "DIR receives table.csv, summary.json and a folder of results for each case. Neither jobs nor "
             "threads "
             "nor a stop and --resume change the table. Ctrl-C stops all cases after their current step.\n"
             "Exit code: 0 done (also when single cases failed: they are rows of the table), 1 all cases "
             "failed or "
             "the study could not go on, 2 the input is wrong.",
     .examples = {{"capsella study configs/studies/compare_criteria.yaml",
                   "when and where ten criteria see a capsule rupture"},
                  {"capsella study study.yaml --set accuracy=draft", "a first look, coarse and fast"},
                  {"capsella study study.yaml --resume", "go on where it was stopped"}}},

    {.name = "laws",
     .about = "list the laws of membrane and damage, show one, check one, start a new one",
     .options = {{.value = "COMMAND", .kind = VALUE_COMMAND_2,
                  .about = "one of the commands below; without it, list"}},
     .text = WHERE_LAWS_ARE,
     .examples = {{"capsella laws", "all laws"},
                  {"capsella laws show marigo", "equations and parameters of one"},
                  {"capsella laws new my_law --kind damage",
                   "a folder with a law that builds, to be changed"}}},

    {.name = "laws list",
     .about = "every law on the search path: kind, id, title, file",
     .options = {{.flag = "--markdown", .about = "as a page that links to one page for each law"}},
     .text = WHERE_LAWS_ARE,
     .examples = {{"capsella laws list", NULL},
                  {"MLAW_PLUGIN_PATH=my_law capsella laws list", "with those of a folder of one's own"}}},

    {.name = "laws show",
     .about = "one law: equations, parameters with units and ranges, moduli, channels, source",
     .options = {LAW,
                 {.flag = "--markdown", .about = "as a page of Markdown"},
                 {.flag = "--timing", .about = "with nanoseconds per point"}},
     .text = "Only one of the two options may be given.",
     .examples = {{"capsella laws show skalak", NULL},
                  {"capsella laws show ./my_law.so", "a law that is not on the search path"}}},

    {.name = "laws plot",
     .about = "tensions or damage against stretch, as a chart",
     .options = {LAW,
                 {.flag = "-o", .value = "FILE.svg", .kind = VALUE_FILE,
                  .about = "where the chart goes (default: ID.svg)"},
                 {.flag = "--set", .value = "PARAMETER=VALUE", .repeats = true,
                  .about = "a parameter of the law, without unit"}},
     .text = "A constitutive law: tensions against stretch, uniaxial, equibiaxial and in pure shear.\n"
             "A damage law: damage, drive, threshold and tension of a neo-Hookean membrane (G_s = 1) that is "
             "stretched in pure shear at unit rate, unloaded, and stretched again.",
     .examples = {{"capsella laws plot skalak --set C=10", NULL},
                  {"capsella laws plot marigo --set Y_D=0.2 --set Y_C=2 -o damage.svg", NULL}}},

    {.name = "laws check",
     .about = "does a plugin keep the rules, and are its laws sound?",
     .options = {{.value = "FILE.so", .kind = VALUE_LIBRARY, .required = true, .about = "the plugin"},
                 {.flag = "--only", .value = "REGEX",
                  .about = "only tests whose group/name matches, as in --only energy/ or --only "
                           "'hole|overrun'"},
                 {.flag = "--time-limit", .value = "SECONDS", .about = "for each test; 10 without it"},
                 {.flag = "--json", .about = "one JSON object: file, results, counts"},
                 {.flag = "--tap", .about = "the Test Anything Protocol, for a harness such as prove"},
                 {.flag = "--in-process",
                  .about = "no process of its own for a test, for a debugger: a crash ends the check"},
                 {.flag = "--replay", .value = "FILE", .kind = VALUE_FILE,
                  .about = "alone, without FILE.so: evaluates again the points on which a law failed in a "
                           "run, from "
                           "its law_failure.yaml"}},
     .text = "Each test runs in a process of its own.\n"
             "Exit code: 0 every test passed (or did not apply), 1 some did not, 2 the call is wrong.",
     .examples = {{"capsella laws check my_law/my_law.so", NULL},
                  {"capsella laws check my_law/my_law.so --only damage/", "the tests of damage laws alone"},
                  {"capsella laws check --replay results/run/law_failure.yaml",
                   "why a run stopped in a law"}}},

    {.name = "laws new",
     .about = "a folder with a law that builds, to be changed into yours",
     .options = {{.value = "DIR", .kind = VALUE_FOLDER, .required = true,
                  .about = "a folder that is not there yet; it receives the law, a Makefile, a "
                           "CMakeLists.txt, the "
                           "headers, and a scene"},
                 {.flag = "--kind", .value = "KIND", .kind = VALUE_CHOICE, .required = true,
                  .choices = "constitutive damage damage-general",
                  .about = "constitutive: elasticity, an energy of the strain; damage: a function of the "
                           "largest "
                           "energy release rate so far; damage-general: damage and history stepped in time, "
                           "from any "
                           "channel"},
                 {.flag = "--cxx", .about = "in C++ (C++20) in place of C"},
                 {.flag = "--name", .value = "ID",
                  .about = "the law's id, such as acme.creep; the name of DIR without it"}},
     .examples = {{"capsella laws new my_law --kind constitutive", NULL},
                  {"capsella laws new creep --kind damage-general --cxx --name acme.creep", NULL}}},

    {.name = "report",
     .about = "make page and pictures from a folder of results",
     .options = {{.value = "DIR", .kind = VALUE_FOLDER, .required = true,
                  .about = "the folder of a run or of a study"},
                 {.flag = "--color", .value = "FIELD", .kind = VALUE_CHOICE, .choices = "d Y T1 T2",
                  .about = "what the capsule is coloured by (default: d, without damage Y)"},
                 {.flag = "--time", .value = "T", .about = "when it is seen: at the nearest snapshot (default: the newest)"}},
     .text = "Writes the page DIR/report.html and two pictures for papers: DIR/capsule.svg, deformed and at rest, "
             "with the place of first rupture or of the largest damage marked, and DIR/curves.svg. "
             "`rsvg-convert -z 2 capsule.svg -o capsule.png` makes a PNG, with -f pdf a PDF. "
             "Of a study's folder, it makes the page.",
     .examples = {{"capsella report results/shear_reference", NULL},
                  {"capsella report results/shear_reference --color T1 --time 3", "the larger tension, at t = 3"}}},

    {.name = "maps",
     .about = "draw maps of fields over the membrane, from the snapshots of runs",
     .options = {{.value = "DIR", .kind = VALUE_FOLDER, .required = true, .repeats = true,
                  .about = "the folder of a run; of several, the last states stand side by side"},
                 {.flag = "--at", .value = "T,T...",
                  .about = "the snapshots of one run that are nearest to these times (default: the newest)"},
                 {.flag = "--field", .value = "NAME,NAME...",
                  .about = "d, Y, T1, T2, T2- (its negative part), q.n (default: d)"},
                 {.flag = "--view", .value = "NAME,NAME...",
                  .about = "shear (along the vorticity axis), transverse (along e_2), flow (along the "
                           "gradient), reference (the sphere at rest) (default: shear)"},
                 {.flag = "--range", .value = "LOW:HIGH",
                  .about = "of the colours (default: what each row shows)"},
                 {.flag = "-o", .value = "FILE.svg", .kind = VALUE_FILE,
                  .about = "where the maps go (default: DIR/maps.svg)"}},
     .text = "One picture, a row for each field and view, a column for each state, all at one scale.",
     .examples = {{"capsella maps results/fig10 --at 1.1,2,3.4,10 --view transverse,shear,reference",
                   "how damage spreads"},
                  {"capsella maps results/sweep/cases/* --range 0:0.2", "the last states of a study that "
                                                                        "keeps them"}}},

    {.name = "bench",
     .about = "measure run time against error on this machine",
     .options = {{.flag = "--full", .about = "finer meshes and more points: a quarter of an hour or so "
                                             "(without: a few "
                                             "minutes)"},
                 FOLDER("where they go (default: results/benchmarks)")},
     .text = "Measures run time against error of two cases on a grid of mesh, method, integrator and "
             "tolerance, the "
             "cost of one evaluation and the accuracy of the single layer; writes benchmarks.md and its "
             "pictures.",
     .examples = {{"capsella bench", NULL}}},

    {.name = "manual",
     .about = "print every key of a scene file, JSON Schemas, or files for the system",
     .options = {{.flag = "--json-schema", .value = "WHAT", .kind = VALUE_CHOICE, .choices = "scene study",
                  .about = "the JSON Schema of a scene or of a study, by which an editor completes and "
                           "checks"},
                 {.flag = "--files", .value = "DIR", .kind = VALUE_FOLDER,
                  .about = "write man pages, completions of bash and zsh, and the schemas below DIR"}},
     .text = "Without an option: the keys of a scene, as a page of Markdown. Only one of the options may be "
             "given.",
     .examples = {{"capsella manual | less", NULL},
                  {"capsella manual --json-schema scene > scene.schema.json",
                   "then, as first line of a scene: # yaml-language-server: $schema=scene.schema.json"},
                  {"capsella manual --files ~/.local/share", "for a program that was built, not installed"}}},

    {.name = "help",
     .about = "what a command takes",
     .options = {{.value = "COMMAND", .kind = VALUE_COMMAND, .about = "a command; without it, all of them"},
                 {.value = "SUBCOMMAND", .kind = VALUE_COMMAND_2, .about = "a command of `capsella laws`"}},
     .examples = {{"capsella help run", NULL}, {"capsella help laws check", NULL}}},
};
/* clang-format on */

const size_t N_HELP_PAGES = sizeof HELP_PAGES / sizeof *HELP_PAGES;
