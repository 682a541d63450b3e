#pragma once

#include <QObject>
#include <map>
#include <string>

#include "core/registration/RegistrationResult.h"

namespace vestige {

class Document;
class Preview;
class Selection;
struct Layer;

/// Registrations that found no pose to rely on, by layer. They do not move the layer, but what they found can
/// be looked at, and of several candidates one can be chosen. Not part of the case, so no edits.
class Attempts : public QObject {
    Q_OBJECT

  public:
    Attempts(const Document& document, Preview& preview, QObject* parent = nullptr);

    /// Null for a layer without one.
    const RegistrationResult* of(const std::string& layer) const;
    void set(const std::string& layer, RegistrationResult result);
    void forget(const std::string& layer);

    /// The candidate that is chosen, an index into the result's candidates; 0 at first.
    std::size_t chosen(const std::string& layer) const;
    void choose(const std::string& layer, std::size_t candidate);
    /// The chosen candidate's pose, or the one that was found where there are no candidates.
    Similarity pose(const std::string& layer) const;

    void showPreview(const std::string& layer, bool show);
    bool previewed(const std::string& layer) const;

  signals:
    void changed();

  private:
    struct Attempt {
        RegistrationResult result;
        std::size_t chosen = 0;
    };
    void dropOutdated();

    const Document& document_;
    Preview& preview_;
    std::map<std::string, Attempt> attempts_;
    std::string target_;     ///< that they were made with
    std::string previewed_;  ///< the layer that the preview shows for this object
};

/// The registration that panel and strip describe: that of the selected layer, else the last one in the list.
struct ShownFit {
    const Layer* layer = nullptr;
    const RegistrationResult* result = nullptr;
    bool entered = false;  ///< the layer stands there; otherwise it was refused
};
ShownFit shownFit(const Document& document, const Selection& selection, const Attempts& attempts);

}  // namespace vestige
