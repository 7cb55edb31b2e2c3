"""Every configuration fits its JSON Schema, and mistakes do not:  schema_check.py SCENE STUDY FOLDER PROGRAM"""

import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema
import yaml


class Loader(yaml.SafeLoader):
    """YAML 1.2 as editors read it: `off` is a word, and 1e-3 a number."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern in (
    ("bool", r"true|false"),
    ("int", r"[-+]?[0-9]+"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?"),
):
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^({pattern})$"), None)
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))


def validator(path):
    schema = json.load(open(path))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def load(path):
    return yaml.load(open(path), Loader)


scene_validator, study_validator = validator(sys.argv[1]), validator(sys.argv[2])
folder, program = pathlib.Path(sys.argv[3]), sys.argv[4]
failures = []
scenes = []
files = sorted(folder.rglob("*.yaml"))
for path in files:
    config = load(path)
    is_study = "study" in config
    for error in (study_validator if is_study else scene_validator).iter_errors(config):
        failures.append(f"{path}: {error.json_path}: {error.message[:200]}")
    if not is_study:
        scenes.append((path, config))
if len(scenes) < 5 or len(scenes) == len(files):
    failures.append(f"expected several scenes and a study in {folder}, found {len(scenes)} scenes")

# Mistakes that the schema knows: each is refused by the program, too.
MISTAKES = (
    (("capsule", "mesh", "subdivisions"), 9),
    (("capsule", "mesh", "subdivisions"), "two"),
    (("flow", "kind"), "simple_shaer"),
    (("flow", "capilary_number"), 0.7),
    (("flow", "capillary_number"), 0),
    (("membrane", "law"), None),
    (("membrane", "damage", "d_max"), 1.5),
    (("time", "end"), None),
    (("time", "step"), "automatic"),
    (("schema",), 2),
    (("accuracy",), "finest"),
)
base = load(folder / "shear_quick.yaml")
for keys, value in MISTAKES:
    config = copy.deepcopy(base)
    inner = config
    for key in keys[:-1]:
        inner = inner.setdefault(key, {})
    inner[keys[-1]] = value
    if value is None:
        del inner[keys[-1]]
    if scene_validator.is_valid(config):
        failures.append(f"{'.'.join(keys)} = {value} fits the schema")
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        yaml.safe_dump(config, file)
        file.flush()
        code = subprocess.run([program, "run", file.name, "--dry-run"], capture_output=True).returncode
        if code != 2:
            failures.append(f"{'.'.join(keys)} = {value}: the program ends with {code}")

study = load(folder / "studies" / "compare_criteria.yaml")
for change in ({"study": "sweep"}, {"mode": "active"}, {"bracket": [0.1, 1.2]}, {"find": ["Ca_l"]}, {"criteria": []}):
    if study_validator.is_valid({**study, **change}):
        failures.append(f"a comparison with {change} fits the schema")

print("\n".join(failures))
sys.exit(bool(failures))
