// intersect KIND [--time]: answers rays against single primitives, one question a line on stdin, by
// the functions that a render calls. For testing; the format is in
// Documentation/numerics_solids.md.
#include "rt/accel/mesh_tree.h"
#include "rt/core/transform.h"
#include "rt/geometry/box.h"
#include "rt/geometry/cone.h"
#include "rt/geometry/cylinder.h"
#include "rt/geometry/sphere.h"
#include "rt/geometry/torus.h"
#include "rt/geometry/triangle.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

struct Answer {
    double t = 0.0;
    Vec3 normal{0.0};
};

class Subject {
  public:
    virtual ~Subject() = default;
    /// The nearest hit and its outward unit normal, in object space.
    virtual bool closest(const Ray& ray, Interval range, Answer& answer) const = 0;
};

template <class Solid>
class SolidSubject : public Subject {
  public:
    explicit SolidSubject(const Solid& solid) : solid_(solid) {}
    bool closest(const Ray& ray, Interval range, Answer& answer) const override {
        PrimitiveHit hit;
        if (!solid_.intersect(ray, range, hit)) return false;
        answer = {hit.t, solid_.surface(hit).normal};
        return true;
    }

  private:
    Solid solid_;
};

class MeshSubject : public Subject {
  public:
    explicit MeshSubject(TriangleMesh mesh)
        : mesh_(std::move(mesh)), tree_(MeshTree::build(mesh_, 1)) {}
    bool closest(const Ray& ray, Interval range, Answer& answer) const override {
        PrimitiveHit hit;
        if (!tree_.closestHit(ray, range, hit)) return false;
        answer = {hit.t, triangleSurface(mesh_, hit.part, hit).normal};
        return true;
    }

  private:
    TriangleMesh mesh_;
    MeshTree tree_;
};

using SubjectPointer = std::unique_ptr<Subject>;

/// Spheres: centre, radius.
SubjectPointer readSphere(Numbers& in) {
    const Vec3 centre = in.vec();
    return std::make_unique<SolidSubject<Sphere>>(Sphere(centre, in.next()));
}

SubjectPointer readBox(Numbers& in) {
    const Vec3 lo = in.vec();
    return std::make_unique<SolidSubject<Box>>(Box(lo, in.vec()));
}

/// Cylinders, cones and tori: an anchor and two lengths.
template <class Solid>
SubjectPointer readRound(Numbers& in) {
    const Vec3 anchor = in.vec();
    const double first = in.next();
    return std::make_unique<SolidSubject<Solid>>(Solid(anchor, first, in.next()));
}

SubjectPointer readTriangle(Numbers& in) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(in.vec());
    mesh.triangles.push_back({0, 1, 2});
    return std::make_unique<MeshSubject>(std::move(mesh));
}

SubjectPointer readFan(Numbers& in) {
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
    return std::make_unique<MeshSubject>(std::move(mesh));
}

struct Kind {
    const char* name;
    SubjectPointer (*read)(Numbers& in);
    bool hasMinimum;  ///< the question ends in tmin
};

constexpr Kind kKinds[] = {
    {"sphere", readSphere, true},
    {"box", readBox, true},
    {"cylinder", readRound<Cylinder>, true},
    {"cone", readRound<Cone>, true},
    {"torus", readRound<Torus>, true},
    {"triangle", readTriangle, true},
    {"fan", readFan, false},
};

struct Question {
    SubjectPointer subject;
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
    Question question;
    question.subject = kind.read(in);
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

/// As a render asks: into object space, the primitive, and the normal back.
bool ask(const Question& question, Answer& answer) {
    const Ray local = question.transform.toObject(question.ray);
    if (!question.subject->closest(local, question.range, answer)) return false;
    if (!question.transform.isIdentity()) {
        answer.normal = question.transform.normalToWorld(answer.normal);
    }
    return true;
}

void printAnswers(const std::vector<Question>& questions) {
    for (const Question& question : questions) {
        Answer answer;
        if (ask(question, answer)) {
            const Vec3& n = answer.normal;
            std::printf("%a %a %a %a\n", answer.t, n.x, n.y, n.z);
        } else {
            std::puts("miss");
        }
    }
}

/// Median over several passes of the time for one question.
double nanosecondsPerRay(const std::vector<Question>& questions) {
    constexpr int kPasses = 11;
    constexpr std::size_t kRaysPerPass = 200000;
    const std::size_t rounds = std::max<std::size_t>(1, kRaysPerPass / questions.size());
    std::vector<double> passes;
    volatile double sink = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
        const auto start = std::chrono::steady_clock::now();
        double sum = 0.0;
        for (std::size_t round = 0; round < rounds; ++round) {
            for (const Question& question : questions) {
                Answer answer;
                if (ask(question, answer)) sum += answer.t + answer.normal.x;
            }
        }
        sink = sink + sum;
        const std::chrono::duration<double, std::nano> spent =
            std::chrono::steady_clock::now() - start;
        passes.push_back(spent.count() / static_cast<double>(rounds * questions.size()));
    }
    std::nth_element(passes.begin(), passes.begin() + kPasses / 2, passes.end());
    return passes[kPasses / 2];
}

int usage() {
    std::fputs("usage: intersect KIND [--time] < questions; KIND is one of", stderr);
    for (const Kind& kind : kKinds) std::fprintf(stderr, " %s", kind.name);
    std::fputs("\n", stderr);
    return kExitBadInput;
}

int run(const Kind& kind, bool time) {
    const std::vector<Question> questions = readQuestions(kind, std::cin);
    printAnswers(questions);
    if (time && !questions.empty()) {
        std::fprintf(stderr, "ns_per_ray %.1f\n", nanosecondsPerRay(questions));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const bool time = argc == 3 && std::string(argv[2]) == "--time";
    if (argc != 2 && !time) return usage();
    const Kind* const kind = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const Kind& k) {
        return std::string(argv[1]) == k.name;
    });
    if (kind == std::end(kKinds)) return usage();
    try {
        return run(*kind, time);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "intersect: %s\n", error.what());
        return kExitBadInput;
    }
}
