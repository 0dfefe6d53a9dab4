#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor face_descriptor;
typedef Mesh::Property_map<edge_descriptor, bool>  Cut_map;

namespace SMC = CGAL::Surface_mesh_cutting;

#if CGAL_VERSION_NR >= 1060000000

// Since 6.0 a mesh is drawn in the colors of its edges.
void draw_cut(Mesh& mesh, Cut_map is_cut)
{
  auto color = mesh.add_property_map<edge_descriptor, CGAL::IO::Color>("e:color", CGAL::IO::black()).first;
  for(edge_descriptor e : edges(mesh))
    if(is_cut[e])
      color[e] = CGAL::IO::red();
  CGAL::draw(mesh);
}

#else

struct Cut_viewer : public CGAL::SimpleFaceGraphViewerQt
{
  Cut_viewer(QWidget* parent, const Mesh& mesh, Cut_map is_cut)
    : SimpleFaceGraphViewerQt(parent, mesh, "Cut", false, [](const Mesh&, face_descriptor) { return CGAL::IO::gray(); }),
      mesh(mesh), is_cut(is_cut)
  {}

  void init() override
  {
    compute_elements();
    for(edge_descriptor e : edges(mesh))
      if(is_cut[e])
        add_segment(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)), CGAL::IO::red());
    Basic_viewer_qt::init();
  }

  const Mesh& mesh;
  Cut_map is_cut;
};

void draw_cut(Mesh& mesh, Cut_map is_cut)
{
  if(qEnvironmentVariableIsSet("CGAL_TEST_SUITE"))
    return;
  CGAL::Qt::init_ogl_context(4, 3);
  int argc = 1;
  char name[] = "draw_cut_example";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  Cut_viewer viewer(application.activeWindow(), mesh, is_cut);
  viewer.show();
  application.exec();
}

#endif

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  Cut_map is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh) || !SMC::greedy_cut(mesh, is_cut))
    return EXIT_FAILURE;
  draw_cut(mesh, is_cut);
  return EXIT_SUCCESS;
}
