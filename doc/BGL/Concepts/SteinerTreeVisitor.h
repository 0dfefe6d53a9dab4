/*!
\ingroup PkgSurfaceMeshCuttingSteinerTreesConcepts
\cgalConcept

The concept `SteinerTreeVisitor` is what the named parameter `visitor` of `CGAL::steiner_tree()` requires. A visitor is copied
unless it is passed by `std::ref`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Steiner_tree::Default_visitor}
\cgalHasModelsEnd
*/
class SteinerTreeVisitor
{
public:
  /// is asked often.
  /// \return `false` to cancel the computation; the best tree found until then is returned, with the status
  ///         `CGAL::Steiner_tree::Status::CANCELLED`
  bool go_further();
};
