/*!
\ingroup PkgSurfaceMeshCuttingConcepts
\cgalConcept

The concept `CuttingVisitor` describes the requirements for the named parameter `visitor` of all functions of this package
that take one, such as `CGAL::Surface_mesh_cutting::greedy_cut()` and `CGAL::Surface_mesh_cutting::unwrap()`. A visitor
follows the progress of a run and can end it. These functions copy it unless it is passed by `std::ref`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_cutting::Default_visitor}
\cgalHasModelsEnd
*/
class CuttingVisitor
{
public:
  /// is called often, but by one thread at a time.
  /// \return `false` to end the run, which then returns `CGAL::Surface_mesh_cutting::Status_code::STOPPED` and the best
  /// result so far
  bool go_further();

  /// is called with the current phase when `fraction`, a number from 0 to 1, of the whole run is done. The fraction is an
  /// estimate; it never decreases, and is 1 when the run has succeeded. Phases recur, since each start goes through them.
  /// `CGAL::Surface_mesh_cutting::connect_points()`, `CGAL::Surface_mesh_cutting::cut_handles()` and
  /// `CGAL::Surface_mesh_cutting::visibility_weights()` do not call it.
  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction);

  /// is called once with what the run took, at the end of `CGAL::Surface_mesh_cutting::greedy_cut()`,
  /// `CGAL::Surface_mesh_cutting::detect_feature_points()`, `CGAL::Surface_mesh_cutting::unwrap()`, and
  /// `CGAL::Surface_mesh_cutting::unwrap_polygon_soup()`, with any status. Other functions do not call it.
  void ended(const CGAL::Surface_mesh_cutting::Run_profile& profile);
};
