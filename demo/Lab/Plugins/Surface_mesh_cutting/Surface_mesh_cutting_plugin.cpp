// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "Scene_polyhedron_selection_item.h"
#include "Scene_surface_mesh_item.h"
#include "Scene_textured_surface_mesh_item.h"
#include "SMesh_type.h"
#include "ui_Surface_mesh_cutting_dialog.h"

#include <CGAL/Three/CGAL_Lab_plugin_helper.h>
#include <CGAL/Three/CGAL_Lab_plugin_interface.h>
#include <CGAL/Three/Three.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/boost/graph/helpers.h>

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QMainWindow>
#include <QMetaObject>
#include <QProgressDialog>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <limits>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;

namespace {

// Textures have coordinates of this type, so that the proof of the map is one for what is shown.
typedef CGAL::Simple_cartesian<float>::Point_2 UV;

struct Settings
{
  double bound = (std::numeric_limits<double>::infinity)();
  SMC::Effort effort = SMC::Effort::DEFAULT;
  bool do_bijective = false;
  bool make_uvs = false;
};

// Connects the run in its thread with the dialog in that of the interface: the library may call a visitor from any thread.
struct Run_state
{
  std::atomic<int> percent{0};
  std::atomic<bool> is_canceled{false};
};

struct Progress_visitor : public SMC::Default_visitor
{
  Run_state* state;

  explicit Progress_visitor(Run_state& state) : state(&state) {}
  bool go_further() const { return !state->is_canceled; }
  void progress(SMC::Phase, double fraction) { state->percent = int(100 * fraction); }
};

struct Cut_mesh
{
  boost::property_map<SMesh, CGAL::dynamic_edge_property_t<bool> >::const_type is_cut;
  boost::property_map<SMesh, CGAL::dynamic_halfedge_property_t<UV> >::const_type uv;
  SMC::Unwrap_result<SMesh> result;
};

Cut_mesh cut(const SMesh& mesh, const Settings& settings, Run_state& state)
{
  Cut_mesh cut_mesh = { get(CGAL::dynamic_edge_property_t<bool>(), mesh), get(CGAL::dynamic_halfedge_property_t<UV>(), mesh), {} };
  Progress_visitor visitor(state);
  cut_mesh.result = SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, cut_mesh.is_cut, cut_mesh.uv,
                                                                 CGAL::parameters::maximum_average_distortion(settings.bound)
                                                                                  .do_bijective(settings.do_bijective)
                                                                                  .effort(settings.effort)
                                                                                  .visitor(std::ref(visitor)));
  // Charts that do not fit into the unit square, since there are too many, stay as they are.
  if(cut_mesh.result.has_result && settings.make_uvs)
    SMC::pack_charts<CGAL::Parallel_if_available_tag>(mesh, cut_mesh.is_cut, cut_mesh.uv,
                                                      CGAL::parameters::do_bijective(settings.do_bijective)
                                                                       .effort(SMC::Effort::FAST)
                                                                       .visitor(std::ref(visitor)));
  return cut_mesh;
}

// the ends of all edges of the cut, one after the other, as textured items take them
std::vector<float> segments_of_cut(const SMesh& mesh, const Cut_mesh& cut_mesh)
{
  std::vector<float> segments;
  for(SMesh::Edge_index e : edges(mesh))
    if(get(cut_mesh.is_cut, e))
      for(SMesh::Vertex_index v : { source(e, mesh), target(e, mesh) })
        for(int i = 0; i < 3; ++i)
          segments.push_back(float(mesh.point(v)[i]));
  return segments;
}

} // namespace

class CGAL_Lab_surface_mesh_cutting_plugin :
  public QObject,
  public CGAL::Three::CGAL_Lab_plugin_helper
{
  Q_OBJECT
  Q_INTERFACES(CGAL::Three::CGAL_Lab_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.CGALLab.PluginInterface/1.0")

public:
  void init(QMainWindow* main_window, CGAL::Three::Scene_interface* scene_interface, Messages_interface*) override
  {
    mw = main_window;
    scene = scene_interface;
    m_action = new QAction(tr("Cut for Parameterization"), mw);
    m_action->setObjectName("actionCutForParameterization");
    m_action->setProperty("subMenuName", "Triangulated Surface Mesh Parameterization");
    autoConnectActions();
  }

  QList<QAction*> actions() const override { return { m_action }; }
  bool applicable(QAction*) const override { return selected_mesh() != nullptr; }

public Q_SLOTS:
  void on_actionCutForParameterization_triggered();

private:
  Scene_surface_mesh_item* selected_mesh() const;
  bool ask(Settings& settings);
  Cut_mesh cut_with_progress(const SMesh& mesh, const Settings& settings);
  void select_cut(Scene_surface_mesh_item* item, const Cut_mesh& cut_mesh);
  Scene_polyhedron_selection_item* selection_of(Scene_surface_mesh_item* item);
  void add_textured_item(Scene_surface_mesh_item* item, const Cut_mesh& cut_mesh);

  QAction* m_action = nullptr;
};

void CGAL_Lab_surface_mesh_cutting_plugin::on_actionCutForParameterization_triggered()
{
  Scene_surface_mesh_item* item = selected_mesh();
  Settings settings;
  if(item == nullptr || !ask(settings))
    return;

  const SMesh mesh = *item->face_graph(); // a copy, as Lab may draw the item during the run, and adds properties to it then
  const Cut_mesh cut_mesh = cut_with_progress(mesh, settings);
  const SMC::Unwrap_result<SMesh>& result = cut_mesh.result;
  if(!result)
    CGAL::Three::Three::warning(QString::fromStdString(result.status.message));
  if(!result.has_result)
    return;

  if(settings.make_uvs && CGAL::is_triangle_mesh(mesh))
    add_textured_item(item, cut_mesh);
  else if(settings.make_uvs)
    CGAL::Three::Three::warning(tr("Only meshes of triangles can be shown with a texture."));
  select_cut(item, cut_mesh);
  CGAL::Three::Three::information(tr("%1: a cut of length %2, %3 chart(s), mean energy %4 (4 is ideal)")
                                  .arg(item->name()).arg(result.cut_length).arg(result.charts.size())
                                  .arg(result.average_distortion));
}

Scene_surface_mesh_item* CGAL_Lab_surface_mesh_cutting_plugin::selected_mesh() const
{
  for(CGAL::Three::Scene_interface::Item_id id : scene->selectionIndices())
    if(Scene_surface_mesh_item* item = qobject_cast<Scene_surface_mesh_item*>(scene->item(id)))
      return item;
  return nullptr;
}

bool CGAL_Lab_surface_mesh_cutting_plugin::ask(Settings& settings)
{
  QDialog dialog(mw);
  Ui::Surface_mesh_cutting_dialog ui;
  ui.setupUi(&dialog);
  if(dialog.exec() != QDialog::Accepted)
    return false;
  if(ui.bound->value() > ui.bound->minimum()) // which stands for no bound
    settings.bound = ui.bound->value();
  constexpr SMC::Effort efforts[] = { SMC::Effort::FAST, SMC::Effort::DEFAULT, SMC::Effort::BEST };
  settings.effort = efforts[ui.effort->currentIndex()];
  settings.do_bijective = ui.withoutOverlaps->isChecked();
  settings.make_uvs = ui.makeUVs->isChecked();
  return true;
}

Cut_mesh CGAL_Lab_surface_mesh_cutting_plugin::cut_with_progress(const SMesh& mesh, const Settings& settings)
{
  QProgressDialog dialog(tr("Cutting..."), tr("Stop"), 0, 100, mw);
  dialog.setWindowModality(Qt::WindowModal); // nothing changes the mesh in the meantime
  dialog.setAutoClose(false);
  dialog.setAutoReset(false);

  Run_state state;
  std::future<Cut_mesh> run = std::async(std::launch::async, [&] { return cut(mesh, settings, state); });
  while(run.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
  {
    dialog.setValue(state.percent);
    QCoreApplication::processEvents();
    state.is_canceled = dialog.wasCanceled();
  }
  return run.get();
}

// Leaves the mesh and the selection selected, from which the parameterizations of the same menu start.
void CGAL_Lab_surface_mesh_cutting_plugin::select_cut(Scene_surface_mesh_item* item, const Cut_mesh& cut_mesh)
{
  Scene_polyhedron_selection_item* selection = selection_of(item);
  selection->selected_edges.clear();
  for(SMesh::Edge_index e : edges(*item->face_graph()))
    if(get(cut_mesh.is_cut, e))
      selection->selected_edges.insert(e);
  selection->invalidateOpenGLBuffers();
  scene->itemChanged(selection);
  QMetaObject::invokeMethod(mw, "selectSceneItems",
                            Q_ARG(QList<int>, QList<int>({ scene->item_id(item), scene->item_id(selection) })));
}

// There is at most one for each mesh, as in the plugin for selections.
Scene_polyhedron_selection_item* CGAL_Lab_surface_mesh_cutting_plugin::selection_of(Scene_surface_mesh_item* item)
{
  for(int id = 0; id < scene->numberOfEntries(); ++id)
  {
    Scene_polyhedron_selection_item* selection = qobject_cast<Scene_polyhedron_selection_item*>(scene->item(id));
    if(selection != nullptr && selection->polyhedron_item() == item)
      return selection;
  }
  Scene_polyhedron_selection_item* selection = new Scene_polyhedron_selection_item(item, mw);
  selection->setName(tr("%1 (selection)").arg(item->name()));
  scene->addItem(selection);
  return selection;
}

void CGAL_Lab_surface_mesh_cutting_plugin::add_textured_item(Scene_surface_mesh_item* item, const Cut_mesh& cut_mesh)
{
  SMesh textured = *item->face_graph();
  auto u = textured.add_property_map<SMesh::Halfedge_index, float>("h:u", 0.f).first;
  auto v = textured.add_property_map<SMesh::Halfedge_index, float>("h:v", 0.f).first;
  for(SMesh::Halfedge_index h : halfedges(textured))
    if(!is_border(h, textured))
    {
      const UV uv = get(cut_mesh.uv, h);
      u[h] = uv.x();
      v[h] = uv.y();
    }
  Scene_textured_surface_mesh_item* textured_item = new Scene_textured_surface_mesh_item(textured);
  textured_item->setName(tr("%1 (unwrapped)").arg(item->name()));
  textured_item->setColor(Qt::white);
  textured_item->setRenderingMode(item->renderingMode());
  item->setVisible(false);
  scene->addItem(textured_item);
  // Lab does not draw the texture before the item gets lines.
  textured_item->add_border_edges(segments_of_cut(*item->face_graph(), cut_mesh));
}

#include "Surface_mesh_cutting_plugin.moc"
