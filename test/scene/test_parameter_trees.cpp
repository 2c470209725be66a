#include <array>
#include <memory>

#include "scene_text.h"

using poinsot::scene::Body;
using poinsot::scene::Error;
using poinsot::scene::readFile;
using poinsot::scene::readTree;
using poinsot::scene::Scene;

namespace {

std::string outputOf(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    text.append(buffer.data(), count);
  }
  return text;
}

/** The tree as it comes back from a parameter server that PyYAML filled: every scalar as text, doubles with %.17g. */
YAML::Node throughPyYaml(const std::string& path) {
  const std::string script =
      "import json, sys, yaml\n"
      "def text(x):\n"
      "    if isinstance(x, dict): return {k: text(v) for k, v in x.items()}\n"
      "    if isinstance(x, list): return [text(v) for v in x]\n"
      "    if isinstance(x, bool): return str(x).lower()\n"
      "    return '%.17g' % x if isinstance(x, float) else str(x)\n"
      "print(json.dumps(text(yaml.safe_load(open(sys.argv[1])))))\n";
  return YAML::Load(outputOf(PYTHON " -c \"" + script + "\" '" + path + "'"));
}

/** A copy that was never in a file, so that it has no lines. */
YAML::Node withoutLines(const YAML::Node& node) {
  YAML::Node copy;
  if (node.IsScalar()) copy = node.Scalar();
  if (node.IsSequence()) copy = YAML::Node(YAML::NodeType::Sequence);
  if (node.IsMap()) copy = YAML::Node(YAML::NodeType::Map);
  if (node.IsSequence()) {
    for (const auto& entry : node) copy.push_back(withoutLines(entry));
  }
  if (node.IsMap()) {
    for (const auto& entry : node) copy[entry.first.Scalar()] = withoutLines(entry.second);
  }
  return copy;
}

void expectSame(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.warnings.size(), b.warnings.size());
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const Body &x = a.bodies[i], &y = b.bodies[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.inertia.moments(), y.inertia.moments());
    EXPECT_EQ(x.inertia.axes().coeffs(), y.inertia.axes().coeffs());
    EXPECT_EQ(x.shape.has_value(), y.shape.has_value());
    ASSERT_EQ(x.appearance.has_value(), y.appearance.has_value());
    if (x.appearance) {
      EXPECT_EQ(x.appearance->mesh, y.appearance->mesh);
      EXPECT_EQ(x.appearance->scale, y.appearance->scale);
    }
    EXPECT_EQ(x.attitude.coeffs(), y.attitude.coeffs());
    EXPECT_EQ(x.omega_body, y.omega_body);
    EXPECT_EQ(x.method, y.method);
    EXPECT_EQ(x.step, y.step);
    ASSERT_EQ(x.translation.has_value(), y.translation.has_value());
    if (!x.translation) continue;
    EXPECT_EQ(x.translation->position, y.translation->position);
    EXPECT_EQ(x.translation->velocity, y.translation->velocity);
    EXPECT_EQ(x.translation->acceleration, y.translation->acceleration);
  }
}

void expectSameThroughPyYaml(const std::string& path) {
  const YAML::Node tree = throughPyYaml(path);
  ASSERT_TRUE(tree.IsMap()) << "python3-yaml is needed";
  expectSame(readFile(path), readTree(withoutLines(tree), "~scene"));
}

std::string messageOf(const YAML::Node& tree) {
  try {
    readTree(tree, "~scene");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(ParameterTree, GivesTheSceneThatTheFileGives) {
  const scene_text::TemporaryFile file(
      "rate: 1e2\n"
      "bodies:\n"
      "  - name: a\n"
      "    inertia: &tensor [[1, 1e-1, 0], [0.1, +2., 0], [0, 0, '2.5']]\n"
      "    attitude: [.5, -.5, +.5, 1e0]\n"
      "    angular_velocity: [1e-9, 1.0e-9, 0.30000000000000004]\n"
      "    method: rk4\n"
      "    step: 1.e-3\n"
      "  - name: \"b\"\n"
      "    inertia: *tensor\n"
      "    angular_velocity: [00.5, 010e1, 010.5]\n"
      "    method: buss2\n"
      "    step: 1E-5\n"
      "    effects: [{type: translation, position: [1, -1e-400, 4.9e-324], velocity: [0, 0, 3E0]}]\n"
      "  - name: c\n"
      "    shape: {type: cylinder, radius: 1, height: 1e0, mass: 2}\n"
      "    appearance: {mesh: package://poinsot/meshes/book.dae, scale: 1e-3}\n"
      "    angular_velocity: [1, 2, 3]\n");
  expectSameThroughPyYaml(file.path());
}

TEST(ParameterTree, TheScenesOfThePackageDoToo) {
  expectSameThroughPyYaml(SCENES_DIRECTORY "/dzhanibekov.yaml");
  expectSameThroughPyYaml(SCENES_DIRECTORY "/regimes.yaml");
}

TEST(ParameterTree, NeverGivesAnotherSceneThanTheFile) {
  // PyYAML makes 8, 16, 1000 and 90 of these: whatever it does, the file must not read as something else.
  for (const char* number : {"010", "0x10", "1_000", "1:30", "yes", ".inf", "1.0e+999", "!!str 5", "0b11", "1e5"}) {
    SCOPED_TRACE(number);
    const scene_text::TemporaryFile file(scene_text::body({"angular_velocity: [" + std::string(number) + ", 0, 0]"}));
    try {
      const Scene from_file = readFile(file.path());
      expectSame(from_file, readTree(throughPyYaml(file.path()), "~scene"));
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(file.path(), 0), 0u) << "the tree is refused, but not the file\n"
                                                                     << error.what();
    }
  }
  for (const char* name : {"yes", "'yes'", "true", "'true'", "off", "y", "'n'"}) {
    SCOPED_TRACE(name);
    const scene_text::TemporaryFile file("bodies: [{name: " + std::string(name) +
                                         ", inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}]\n");
    EXPECT_THROW(readFile(file.path()), Error);
    EXPECT_THROW(readTree(throughPyYaml(file.path()), "~scene"), Error);
  }
}

TEST(ParameterTree, MessagesNameTheSourceAndNoLine) {
  YAML::Node tree = withoutLines(YAML::Load(scene_text::body({"inertia: [1, 2, -3]"})));
  EXPECT_EQ(messageOf(tree),
            "~scene: bodies[0] \"brick\".inertia[2]: expected a positive finite number (kg·m²), got -3");
  EXPECT_EQ(messageOf(YAML::Node()), "~scene: expected a map with the keys rate, bodies, got null");
  EXPECT_EQ(messageOf(YAML::Node(YAML::NodeType::Undefined)).rfind("~scene: ", 0), 0u);
  const YAML::Node& constant = tree;
  EXPECT_EQ(messageOf(constant["nothing"]).rfind("~scene: ", 0), 0u);
}

TEST(ParameterTree, IsLeftAsItWas) {
  const YAML::Node tree = YAML::Load(scene_text::body({"effects: [{type: translation}]"}));
  const std::string before = YAML::Dump(tree);
  readTree(tree, "~scene");
  EXPECT_EQ(YAML::Dump(tree), before);
}
