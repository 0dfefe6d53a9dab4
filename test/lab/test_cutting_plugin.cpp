// Uses the plugin as a person does: loads a closed mesh, cuts it, and maps it with another plugin.
//   test_cutting_plugin MESH.off FOLDER
// What Lab shows of the two maps is left in the folder, as arap.png and unwrapped.png.

#include "CGALlab.h"
#include "MainWindow.h"
#include "SMesh_type.h"
#include "Scene_polyhedron_selection_item.h"
#include "Scene_surface_mesh_item.h"
#include "Scene_textured_surface_mesh_item.h"

#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>
#include <CGAL/Three/Three.h>
#include <CGAL/Three/Viewer_interface.h>
#include <CGAL/boost/graph/helpers.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QEventLoop>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <set>
#include <vector>

namespace cutting_plugin_test {

typedef CGAL::Simple_cartesian<double>::Point_2 UV;

CGAL::Three::Scene_interface& scene() { return *CGAL::Three::Three::scene(); }

// the last item of a type, or null
template <typename Item>
Item* last_item()
{
  for(int id = scene().numberOfEntries() - 1; id >= 0; --id)
    if(Item* item = qobject_cast<Item*>(scene().item(id)))
      return item;
  return nullptr;
}

void trigger(const char* name)
{
  QAction* action = CGAL::Three::Three::mainWindow()->findChild<QAction*>(name);
  CHECK(action != nullptr, name);
  if(action != nullptr)
    action->trigger();
}

// Fills in the dialog once it is there: the call that opens it returns only after it has been closed.
void answer_dialog(double bound, bool without_overlaps, bool make_uvs)
{
  QTimer::singleShot(0, [=]
  {
    QDialog* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    CHECK(dialog != nullptr);
    if(dialog == nullptr)
      return;
    dialog->findChild<QDoubleSpinBox*>("bound")->setValue(bound);
    dialog->findChild<QComboBox*>("effort")->setCurrentIndex(0);
    dialog->findChild<QCheckBox*>("withoutOverlaps")->setChecked(without_overlaps);
    dialog->findChild<QCheckBox*>("makeUVs")->setChecked(make_uvs);
    dialog->accept();
  });
}

void cut(double bound, bool without_overlaps, bool make_uvs)
{
  answer_dialog(bound, without_overlaps, make_uvs);
  trigger("actionCutForParameterization");
}

// Whether the edges of the selection, and no others, open the mesh to disks.
bool selects_cut(Scene_surface_mesh_item& item, Scene_polyhedron_selection_item& selection)
{
  const SMesh& mesh = *item.face_graph();
  auto is_cut = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(SMesh::Edge_index e : edges(mesh))
    put(is_cut, e, selection.selected_edges.count(e) > 0);
  return selection.polyhedron_item() == &item && CGAL::Surface_mesh_cutting::is_cut_to_disks(mesh, is_cut);
}

// for each face, whether it is counterclockwise in the plane
std::vector<bool> orientations(Scene_textured_surface_mesh_item& item)
{
  SMesh& mesh = *item.textured_face_graph();
  const auto u = mesh.add_property_map<SMesh::Halfedge_index, float>("h:u").first;
  const auto v = mesh.add_property_map<SMesh::Halfedge_index, float>("h:v").first;
  std::vector<bool> result;
  for(SMesh::Face_index f : faces(mesh))
  {
    std::vector<UV> corners;
    for(SMesh::Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      corners.emplace_back(u[h], v[h]);
    result.push_back(CGAL::orientation(corners[0], corners[1], corners[2]) == CGAL::LEFT_TURN);
  }
  return result;
}

double share_counterclockwise(Scene_textured_surface_mesh_item& item)
{
  const std::vector<bool> result = orientations(item);
  return double(std::count(result.begin(), result.end(), true)) / double(result.size());
}

// Saves what Lab shows; it has more than one color in the middle, where the mesh is.
void test_picture(MainWindow& window, const QString& file)
{
  window.updateViewersBboxes(true);
  QEventLoop loop; // until the camera has moved
  QTimer::singleShot(500, &loop, &QEventLoop::quit);
  loop.exec();
  CGAL::Three::Three::mainViewer()->saveSnapshot(file, 900, 900);
  const QImage picture(file);
  std::set<QRgb> colors;
  for(int y = picture.height() / 3; y < 2 * picture.height() / 3; ++y)
    for(int x = picture.width() / 3; x < 2 * picture.width() / 3; ++x)
      colors.insert(picture.pixel(x, y));
  CHECK(colors.size() > 50, colors.size());
}

void test_arap_on_closed_mesh(MainWindow& window, const QString& file, const QString& picture)
{
  window.open(file, "off_plugin");
  Scene_surface_mesh_item* mesh = last_item<Scene_surface_mesh_item>();
  CHECK(mesh != nullptr && CGAL::is_closed(*mesh->face_graph()));
  if(mesh == nullptr)
    return;
  trigger("actionARAP"); // which refuses a closed mesh
  CHECK(scene().numberOfEntries() == 1);

  cut(4.0, false, false);
  Scene_polyhedron_selection_item* selection = last_item<Scene_polyhedron_selection_item>();
  CHECK(selection != nullptr && scene().numberOfEntries() == 2);
  if(selection == nullptr)
    return;
  CHECK(selects_cut(*mesh, *selection));

  trigger("actionARAP");
  Scene_textured_surface_mesh_item* textured = last_item<Scene_textured_surface_mesh_item>();
  CHECK(textured != nullptr && scene().numberOfEntries() == 3);
  if(textured == nullptr)
    return;
  CHECK(share_counterclockwise(*textured) > 0.99); // as such maps may have flips
  test_picture(window, picture);
  textured->setVisible(false);
}

void test_own_map(MainWindow& window, const QString& picture)
{
  window.selectSceneItem(0);
  Scene_polyhedron_selection_item* selection = last_item<Scene_polyhedron_selection_item>();
  const std::size_t former_number = selection->selected_edges.size();
  cut(4.05, true, true);
  CHECK(last_item<Scene_polyhedron_selection_item>() == selection, "a second selection");
  CHECK(selects_cut(*last_item<Scene_surface_mesh_item>(), *selection));
  CHECK(selection->selected_edges.size() > former_number, "the bound has no effect");
  CHECK(scene().numberOfEntries() == 4);
  Scene_textured_surface_mesh_item* textured = last_item<Scene_textured_surface_mesh_item>();
  CHECK(textured->name().endsWith("(unwrapped)") && share_counterclockwise(*textured) == 1);
  test_picture(window, picture);
}

// A mesh of other polygons is cut, too, but not shown with a texture.
void test_polygons(MainWindow& window)
{
  QTemporaryDir folder;
  QFile file(folder.filePath("cube.off"));
  CHECK(file.open(QIODevice::WriteOnly));
  file.write("OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
             "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n");
  file.close();
  window.open(file.fileName(), "off_plugin");
  Scene_surface_mesh_item* mesh = last_item<Scene_surface_mesh_item>();
  cut(4.001, true, true);
  Scene_polyhedron_selection_item* selection = last_item<Scene_polyhedron_selection_item>();
  CHECK(selection->polyhedron_item() == mesh && selection->selected_edges.size() == 7);
  CHECK(scene().numberOfEntries() == 6);
}

} // namespace cutting_plugin_test

int main(int argc, char** argv)
{
  using namespace cutting_plugin_test;

  if(argc != 3)
  {
    std::cerr << "usage: test_cutting_plugin MESH.off FOLDER" << std::endl;
    return EXIT_FAILURE;
  }
  const QString mesh = argv[1], folder = argv[2];
  int number_of_arguments = 1; // Lab would open the others
  CGAL_Lab application(number_of_arguments, argv);
  MainWindow& window = *qobject_cast<MainWindow*>(CGAL::Three::Three::mainWindow());
  test_arap_on_closed_mesh(window, mesh, folder + "/arap.png");
  if(test::number_of_failures() == 0)
  {
    test_own_map(window, folder + "/unwrapped.png");
    test_polygons(window);
  }
  return test::exit_status();
}
