// intersect KIND [--time] [--isa NAME]: answers rays against single primitives, one question a line
// on stdin, by the kernel that a render runs. For testing; the format is in
// tests/vectors/README.md.
#include "rt/render/kernel_choice.h"
#include "rt/trace/trace_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace rt;

constexpr int kExitBadInput = 2;
constexpr double kMostFanTriangles = 1e6;

/// The numbers of one question, in order; decimal or C hex floats.
class Numbers {
  public:
    explicit Numbers(std::istringstream& words) : words_(words) {}

    double next() {
        std::string word;
        if (!(words_ >> word)) throw std::invalid_argument("too few numbers");
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0' || !std::isfinite(value)) {
            throw std::invalid_argument("not a finite number: " + word);
        }
        return value;
    }
    Vec3 vec() {
        const double x = next();
        const double y = next();
        const double z = next();
        return Vec3(x, y, z);
    }
    void expectEnd() {
        std::string word;
        if (words_ >> word) throw std::invalid_argument("more than was expected: " + word);
    }

  private:
    std::istringstream& words_;
};

Shape readSphere(Numbers& in) {
    const Vec3 centre = in.vec();
    return Sphere(centre, in.next());
}

Shape readBox(Numbers& in) {
    const Vec3 lo = in.vec();
    return Box(lo, in.vec());
}

/// Cylinders, cones and tori: an anchor and two lengths.
template <class Solid>
Shape readRound(Numbers& in) {
    const Vec3 anchor = in.vec();
    const double first = in.next();
    return Solid(anchor, first, in.next());
}

Shape readFrustum(Numbers& in) {
    const Vec3 base = in.vec();
    const double height = in.next();
    const double baseRadius = in.next();
    return Frustum(base, height, baseRadius, in.next());
}

Shape readQuadric(Numbers& in) {
    QuadricCoefficients k;
    for (double* coefficient : {&k.xx, &k.yy, &k.zz, &k.xy, &k.yz, &k.zx, &k.x, &k.y, &k.z, &k.c}) {
        *coefficient = in.next();
    }
    const Vec3 lo = in.vec();
    return Quadric(k, lo, in.vec());
}

Shape readHemisphere(Numbers& in) {
    const Vec3 centre = in.vec();
    return Hemisphere(centre, in.next());
}

Shape readRectangle(Numbers& in) {
    const double width = in.next();
    return Rectangle(width, in.next());
}

Shape meshShape(TriangleMesh mesh) {
    auto shape = std::make_shared<MeshShape>();
    shape->mesh = std::move(mesh);
    shape->tree = MeshTree::build(shape->mesh, 1);
    return std::shared_ptr<const MeshShape>(std::move(shape));
}

Shape readTriangle(Numbers& in) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(in.vec());
    mesh.triangles.push_back({0, 1, 2});
    return meshShape(std::move(mesh));
}

Shape readFan(Numbers& in) {
    const double count = in.next();
    if (!(count >= 1.0 && count <= kMostFanTriangles && count == std::floor(count))) {
        throw std::invalid_argument("a fan has 1 to 1000000 triangles, got " +
                                    std::to_string(count));
    }
    const Index triangles = static_cast<Index>(count);
    TriangleMesh mesh;
    for (Index i = 0; i <= triangles; ++i) mesh.positions.push_back(in.vec());
    for (Index i = 0; i < triangles; ++i) {
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % triangles});
    }
    return meshShape(std::move(mesh));
}

struct Kind {
    const char* name;
    Shape (*read)(Numbers& in);
    bool hasMinimum;  ///< the question ends in tmin
};

constexpr Kind kKinds[] = {
    {"sphere", readSphere, true},
    {"box", readBox, true},
    {"cylinder", readRound<Cylinder>, true},
    {"cone", readRound<Cone>, true},
    {"torus", readRound<Torus>, true},
    {"frustum", readFrustum, true},
    {"hemisphere", readHemisphere, true},
    {"quadric", readQuadric, true},
    {"disc", [](Numbers& in) -> Shape { return Disc(in.next()); }, true},
    {"rectangle", readRectangle, true},
    {"plane", [](Numbers&) -> Shape { return Plane(); }, true},
    {"triangle", readTriangle, true},
    {"fan", readFan, false},
};

struct Question {
    Shape shape;
    Transform transform;
    Ray ray;
    Interval range;
};

Affine readMap(Numbers& in) {
    Affine map;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) map.linear[column][row] = in.next();
        map.translation[row] = in.next();
    }
    return map;
}

Question readQuestion(const Kind& kind, const std::string& line) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    Numbers in(words);
    Question question{kind.read(in), {}, {}, {}};
    if (name == "affine" && !Transform::make(readMap(in), question.transform)) {
        throw std::invalid_argument("the map has no finite inverse");
    }
    question.ray.origin = in.vec();
    question.ray.direction = in.vec();
    if (question.ray.direction == Vec3(0.0)) throw std::invalid_argument("a direction of zero");
    if (kind.hasMinimum) question.range.min = in.next();
    in.expectEnd();
    return question;
}

std::vector<Question> readQuestions(const Kind& kind, std::istream& in) {
    std::vector<Question> questions;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        const std::size_t start = line.find_first_not_of(" \t\r");
        if (start == std::string::npos || line[start] == '#') continue;
        try {
            questions.push_back(readQuestion(kind, line));
        } catch (const std::exception& error) {
            throw std::invalid_argument("line " + std::to_string(number) + ": " + error.what());
        }
    }
    return questions;
}

void printAnswers(const TraceKernel& kernel, const std::vector<Question>& questions) {
    for (const Question& q : questions) {
        PrimitiveHit hit;
        Vec3 n;
        if (kernel.intersectShape(q.shape, q.transform, q.ray, q.range, hit, n)) {
            std::printf("%a %a %a %a\n", hit.t, n.x, n.y, n.z);
        } else {
            std::puts("miss");
        }
    }
}

/// Processor time of this thread: what else the machine does counts less.
double threadNanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Median over several passes of the time for one question.
double nanosecondsPerRay(const TraceKernel& kernel, const std::vector<Question>& questions) {
    constexpr int kPasses = 11;
    constexpr std::size_t kRaysPerPass = 200000;
    const std::size_t rounds = std::max<std::size_t>(1, kRaysPerPass / questions.size());
    std::vector<double> passes;
    volatile double sink = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
        const double start = threadNanoseconds();
        double sum = 0.0;
        for (std::size_t round = 0; round < rounds; ++round) {
            for (const Question& q : questions) {
                PrimitiveHit hit;
                Vec3 n;
                if (kernel.intersectShape(q.shape, q.transform, q.ray, q.range, hit, n)) {
                    sum += hit.t + n.x;
                }
            }
        }
        sink = sink + sum;
        const double spent = threadNanoseconds() - start;
        passes.push_back(spent / static_cast<double>(rounds * questions.size()));
    }
    std::nth_element(passes.begin(), passes.begin() + kPasses / 2, passes.end());
    return passes[kPasses / 2];
}

struct Arguments {
    const Kind* kind = nullptr;
    bool time = false;
    std::string isa;  ///< empty: the fastest
};

bool parse(int argc, char** argv, Arguments& out) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--time") {
            out.time = true;
        } else if (word == "--isa" && i + 1 < argc) {
            out.isa = argv[++i];
        } else {
            const Kind* const kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                                  [&](const Kind& k) { return word == k.name; });
            if (kind == std::end(kKinds) || out.kind) return false;
            out.kind = kind;
        }
    }
    return out.kind != nullptr;
}

int usage() {
    std::fputs("usage: intersect KIND [--time] [--isa NAME] < questions; KIND is one of", stderr);
    for (const Kind& kind : kKinds) std::fprintf(stderr, " %s", kind.name);
    std::fputs("\n", stderr);
    return kExitBadInput;
}

int run(const Arguments& arguments) {
    const TraceKernel& kernel = chooseKernel(arguments.isa);
    const std::vector<Question> questions = readQuestions(*arguments.kind, std::cin);
    printAnswers(kernel, questions);
    if (arguments.time && !questions.empty()) {
        std::fprintf(stderr, "ns_per_ray %.1f\n", nanosecondsPerRay(kernel, questions));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    if (!parse(argc, argv, arguments)) return usage();
    try {
        return run(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "intersect: %s\n", error.what());
        return kExitBadInput;
    }
}
