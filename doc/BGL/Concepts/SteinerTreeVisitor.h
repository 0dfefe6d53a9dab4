/*!
\ingroup PkgSurfaceMeshCuttingSteinerTreesConcepts
\cgalConcept

The concept `SteinerTreeVisitor` describes the requirements for the named parameter `visitor` of
`CGAL::steiner_tree()`, which copies the visitor unless it is passed by `std::ref`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Steiner_tree::Default_visitor}
\cgalHasModelsEnd
*/
class SteinerTreeVisitor
{
public:
  /// is called often, but by one thread at a time.
  /// \return `false` to cancel the computation, which then returns the best tree found so far, with the status
  ///         `CGAL::Steiner_tree::Result_status::CANCELLED`
  bool go_further();
};
