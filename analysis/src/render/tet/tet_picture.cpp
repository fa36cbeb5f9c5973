// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/tet_picture.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "render/input/domain_boundary.hpp"
#include "render/scene/legend.hpp"
#include "render/tet/octant_scene.hpp"
#include "render/tet/sphere_scene.hpp"
#include "render/tet/tet_legend.hpp"
#include "render/tet/tet_surface.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

using Polyline = std::vector<Vector3<double>>;

constexpr double kSphereShare = 0.84;                                     // of its panel
constexpr double kPanelGrain = 1.7;                                       // pixels
constexpr double kPanelWidth = 720, kPanelHeight = 960, kLargestSide = 4096;  // pixels

// Sizes that all panels share.
struct Scale {
  int columns = 1, rows = 1;
  double panel_width = 0, panel_height = 0;  // pixels of the window
  double line = 2, unit = 20;

  double least() const { return std::min(panel_width, panel_height); }
  double aspect() const { return panel_width / panel_height; }
  // How far what is drawn is above the middle, for the words below: of half the height.
  double rise() const { return 0.75 * std::max(0.0, 1 - panel_width / panel_height); }
};

Scale scale_of(const TetPicture& picture) {
  Scale scale;
  const bool one = picture.modes.size() == 1;
  scale.columns = static_cast<int>(one ? picture.panels.size() : picture.modes.size());
  scale.rows = static_cast<int>(one ? 1 : picture.panels.size());
  return scale;
}

// One mode: what is drawn in each of its panels.
struct Subject {
  ModeValue mode;
  TetDirections directions;
  TetSurface surface;
};

// Edges with one triangle, as pairs of places in `surface.triangles`: triangle and first corner.
std::vector<std::pair<std::size_t, std::size_t>> boundary_edges(const SurfaceMesh& surface) {
  std::map<std::pair<SurfaceMesh::Index, SurfaceMesh::Index>, int> count;
  const auto key = [&](std::size_t i, std::size_t k) {
    const auto u = surface.triangles[i][k], v = surface.triangles[i][(k + 1) % 3];
    return std::pair{std::min(u, v), std::max(u, v)};
  };
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) ++count[key(i, k)];
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (count[key(i, k)] == 1) edges.emplace_back(i, k);
  return edges;
}

vtkSmartPointer<vtkPolyData> segments(const std::vector<Polyline>& lines) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Polyline& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const auto& p : line) cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetLines(cells);
  return shape;
}

std::array<double, 3> array_of(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

// From one direction to another along the sphere: the chord between distant ones is below it.
Polyline arc(const Vector3<double>& u, const Vector3<double>& v) {
  constexpr double kLongest = 0.05;
  const double chord = std::sqrt(dot(v - u, v - u));
  const int steps = std::max(1, static_cast<int>(std::ceil(chord / kLongest)));
  Polyline line;
  for (int i = 0; i <= steps; ++i) {
    const double w = static_cast<double>(i) / steps;
    const Vector3<double> p = (1 - w) * u + w * v;
    line.push_back(unit(p));
  }
  return line;
}

bool any_visible(const std::vector<Polyline>& lines, const SphereFrame& frame) {
  for (const Polyline& line : lines)
    for (const auto& v : line)
      if (dot(v, frame.viewer) > 0) return true;
  return false;
}

void draw_manifold(vtkRenderer& renderer, const TetPicture& picture, const Subject& subject,
                   bool wires, const Scale& scale, SphereSeen& seen) {
  const bool inside = !(picture.beyond > 1);
  SphereFrame frame =
      sphere_frame(subject.directions, picture.sphere_azimuth, picture.sphere_elevation, false);
  if (inside && inside_is_behind(subject.directions, frame))
    frame =
        sphere_frame(subject.directions, picture.sphere_azimuth, picture.sphere_elevation, true);
  SphereLook look;
  look.texture = picture.texture;
  look.inside = inside;
  look.grid = !wires;
  look.line = scale.line;
  look.radius_pixels = kSphereShare * scale.least() / 2;
  add_sphere(renderer, subject.directions, frame, look);
  for (const auto& v : visible_directions(frame)) seen.add(subject.directions, v, inside);
  if (inside) {
    std::vector<Polyline> loops, edges;
    const auto add = [&](std::vector<Polyline>& lines, const Vector3<double>& u,
                         const Vector3<double>& v) {
      lines.push_back(arc(u, v));
      if (subject.mode.sign() == 0) lines.push_back(arc(-u, -v));
    };
    for (const SurfaceMesh& surface : subject.surface.surfaces) {
      const auto triangles = triangles_on_sphere(surface, subject.directions);
      for (const auto& [i, k] : boundary_edges(surface))
        if (triangles[i]) add(loops, (*triangles[i])[k], (*triangles[i])[(k + 1) % 3]);
      for (const auto& t : triangles)
        for (std::size_t k = 0; wires && t && k < 3; ++k) add(edges, (*t)[k], (*t)[(k + 1) % 3]);
    }
    add_sphere_lines(renderer, frame, edges, kInk, 0.6 * scale.line, 1.003);
    add_sphere_lines(renderer, frame, loops, kFaceCurve, 2.2 * scale.line, 1.005);
    seen.curves = seen.curves || any_visible(loops, frame);
    seen.boundary = seen.boundary || any_visible(boundary_pieces(subject.directions, true), frame);
  }
  if (picture.marked)
    for (const double sign : {1.0, -1.0})
      add_ball(renderer, array_of(sign * *picture.marked), 0.03, kRed);
  aim_at_sphere(renderer, frame, scale.aspect(), kSphereShare, scale.rise());
}

bool is_within(const TetMesh& mesh, const Vector3<double>& point) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const std::array<double, 4> weights = tet_field(mesh, i).weights(point);
    if (*std::min_element(weights.begin(), weights.end()) >= 0) return true;
  }
  return false;
}

std::vector<MarkedPoint> marked_points(const TetPicture& picture, const Subject& subject) {
  std::vector<MarkedPoint> points;
  if (!picture.marked) return points;
  for (const double sign : {1.0, -1.0}) {
    const auto place = subject.directions.place(sign * *picture.marked);
    if (!place) continue;
    const double m = mode(deviator(picture.field.at(*place)));
    points.push_back({*place, m, is_within(subject.surface.mesh, *place)});
  }
  return points;
}

void draw_space(vtkRenderer& renderer, const TetPicture& picture, const Subject& subject,
                bool only_curves, const Scale& scale) {
  const auto domain = domain_boundary(subject.surface.mesh);
  add_domain(renderer, domain, scale.line);
  const double size = diagonal(domain->GetBounds());
  const double zoom = picture.view.zoom;
  const double cell = kPanelGrain * kOversampling * size / scale.least() / zoom;
  if (picture.beyond > 1) {
    std::vector<Polyline> edges;
    const auto& c = picture.field.corners;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k) edges.push_back({c[i], c[k]});
    add_lines(renderer, segments(edges), kInk, 1.5 * scale.line);
  }
  for (const SurfaceMesh& surface : subject.surface.surfaces) {
    if (surface.triangles.empty()) continue;
    const double mode = surface.mode.front();
    if (only_curves) {
      std::vector<Polyline> loops;
      for (const auto& [i, k] : boundary_edges(surface))
        loops.push_back({surface.points[as_size(surface.triangles[i][k])],
                         surface.points[as_size(surface.triangles[i][(k + 1) % 3])]});
      add_lines(renderer, segments(loops), mix(sheet_colour(mode), kInk, 0.25), 3 * scale.line);
      continue;
    }
    const Sheet sheet =
        sheet_of(surface, mode, surface_lines(surface, subject.surface.mesh, picture.texture));
    add_triangles(renderer, sheet.shape, {sheet_colour(mode), 1}, 0.7 * scale.line, cell);
  }
  for (std::size_t i = 0; i < subject.surface.curves.size(); ++i) {
    if (only_curves || subject.surface.curves[i].lines.empty()) continue;
    const Sheet sheet = sheet_of(subject.surface.curves[i], i == 0 ? 1 : -1);
    add_curves(renderer, sheet.shape, {i == 0 ? kGreen : kYellow, 1}, 0.006 * size / zoom);
  }
  for (const MarkedPoint& marked : marked_points(picture, subject))
    if (marked.drawn) add_ball(renderer, array_of(marked.point), 0.019 * size / zoom, kRed);
  double bounds[6];
  domain->GetBounds(bounds);
  Frame frame{scale.aspect(), scale.rise(), 0.12, {}};
  for (const auto& p : subject.surface.mesh.points) frame.points.push_back(array_of(p));
  aim(renderer, bounds, picture.view, frame);
}

bool is_sphere(Panel panel) { return panel == Panel::manifold || panel == Panel::triangles; }

// Whether there is nothing of this mode in space.
bool is_empty(const Subject& subject) {
  const auto& [mesh, surfaces, curves, notes] = subject.surface;
  if (surfaces.empty())
    return std::all_of(curves.begin(), curves.end(), [](const auto& c) { return c.lines.empty(); });
  return std::all_of(surfaces.begin(), surfaces.end(),
                     [](const auto& s) { return s.triangles.empty(); });
}

std::string title_of(const ModeValue& mode) {
  const double value = std::abs(mode.approx());
  return value == 0 ? "mode 0" : fmt::format("mode \u00b1{:.6g}", value);
}

}  // namespace

std::vector<Panel> parse_panels(std::string_view text) {
  std::vector<Panel> panels;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    if (name == "curves") {
      panels.push_back(Panel::curves);
    } else if (name == "manifold") {
      panels.push_back(Panel::manifold);
    } else if (name == "triangles") {
      panels.push_back(Panel::triangles);
    } else if (name == "surface") {
      panels.push_back(Panel::surface);
    } else if (name == "octant") {
      panels.push_back(Panel::octant);
    } else {
      throw UsageError(fmt::format(
          "--panels {}: must be some of curves, manifold, triangles, surface, octant, with commas",
          text));
    }
    begin = end + 1;
  }
  return panels;
}

void set_default_size(TetPicture& picture) {
  const Scale scale = scale_of(picture);
  const double fit = std::min(
      {1.0, kLargestSide / (kPanelWidth * scale.columns), kLargestSide / (kPanelHeight * scale.rows)});
  picture.view.width = static_cast<int>(fit * kPanelWidth * scale.columns);
  picture.view.height = static_cast<int>(fit * kPanelHeight * scale.rows);
}

TetImage draw_tet(const TetPicture& picture) {
  Scale scale = scale_of(picture);
  const bool one = picture.modes.size() == 1;
  scale.panel_width = static_cast<double>(picture.view.width) * kOversampling / scale.columns;
  scale.panel_height = static_cast<double>(picture.view.height) * kOversampling / scale.rows;
  scale.line = std::max(1.0, scale.least() / kOversampling / 560) * kOversampling;
  // Of more columns each is drawn smaller in the end.
  scale.unit = (0.034 + 0.008 * std::min(scale.columns, 3)) * scale.least();

  TetImage result;
  std::vector<Subject> subjects;
  for (const ModeValue& mode : picture.modes) {
    subjects.push_back({mode, TetDirections(picture.field, mode),
                        tet_surface(picture.field, mode, picture.beyond)});
    for (const MarkedPoint& point : marked_points(picture, subjects.back()))
      result.marked.push_back(point);
    const auto& notes = subjects.back().surface.notes;
    result.notes.insert(result.notes.end(), notes.begin(), notes.end());
    const bool only_octants = std::count(picture.panels.begin(), picture.panels.end(),
                                         Panel::octant) == std::ssize(picture.panels);
    if (!only_octants && is_empty(subjects.back())) result.missed.push_back(mode);
  }
  std::vector<vtkSmartPointer<vtkRenderer>> scenes;
  SphereSeen seen;
  for (std::size_t m = 0; m < subjects.size(); ++m) {
    for (std::size_t p = 0; p < picture.panels.size(); ++p) {
      const auto column = static_cast<double>(one ? p : m), row = static_cast<double>(one ? 0 : p);
      scenes.push_back(new_scene({column / scale.columns, 1 - (row + 1) / scale.rows,
                                  (column + 1) / scale.columns, 1 - row / scale.rows}));
      vtkRenderer& scene = *scenes.back();
      const Panel panel = picture.panels[p];
      if (panel == Panel::octant) {
        add_octant(scene, subjects[m].directions, scale.line);
        aim_at_octant(scene, scale.aspect(), kSphereShare, scale.rise());
      } else if (is_sphere(panel)) {
        draw_manifold(scene, picture, subjects[m], panel == Panel::triangles, scale, seen);
      } else {
        draw_space(scene, picture, subjects[m], panel == Panel::curves, scale);
      }
      if (p == 0) add_title(scene, title_of(subjects[m].mode), scale.unit, scale.panel_height);
    }
  }
  // In the first column, of all columns.
  std::vector<const TetSurface*> surfaces;
  for (const Subject& subject : subjects) surfaces.push_back(&subject.surface);
  for (std::size_t p = 0; p < picture.panels.size(); ++p) {
    const Panel panel = picture.panels[p];
    if (panel == Panel::triangles) continue;
    add_legend(*scenes[p],
               panel == Panel::octant ? octant_legend()
               : is_sphere(panel)     ? sphere_legend(seen, !(picture.beyond > 1))
                                      : space_legend(surfaces, panel == Panel::surface),
               scale.unit);
  }
  result.image = grab(scenes, picture.view.width, picture.view.height);
  return result;
}

}  // namespace tensortopo
