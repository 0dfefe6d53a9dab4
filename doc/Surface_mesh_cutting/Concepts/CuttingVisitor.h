/*!
\ingroup PkgSurfaceMeshCuttingConcepts
\cgalConcept

The concept `CuttingVisitor` is what the named parameter `visitor` of `CGAL::Surface_mesh_cutting::greedy_cut()`,
`CGAL::Surface_mesh_cutting::unwrap()`, `CGAL::Surface_mesh_cutting::detect_feature_points()` and
`CGAL::Surface_mesh_cutting::connect_points()` requires: it is told about the progress of a run and can end it. A visitor is copied
unless it is passed by `std::ref`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_cutting::Default_visitor}
\cgalHasModelsEnd
*/
class CuttingVisitor
{
public:
  /// is asked often, but by one thread at a time.
  /// \return `false` to end the run, which then returns `CGAL::Surface_mesh_cutting::Status_code::STOPPED`
  bool go_further();

  /// is told that `fraction`, a number from 0 to 1, of a phase is done. Not called by `CGAL::Surface_mesh_cutting::connect_points()`.
  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction);
};
