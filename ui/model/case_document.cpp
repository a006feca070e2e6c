#include "model/case_document.h"

#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "model/enough_memory.h"
#include "model/recovery.h"
#include "scenes/case_sources.h"
#include "scenes/scenes.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/plain_title.h"

namespace ravnoves {

namespace {

const QString ending = QStringLiteral(".case.json");
const QString recentKey = QStringLiteral("files/recent");
constexpr int recentFiles = 8;

/// Those that live.
QList<const CaseDocument*>& documents() {
    static QList<const CaseDocument*> all;
    return all;
}

void remember(const QString& path) {
    QStringList files = CaseDocument::recentPaths();
    if (files.value(0) == path) {
        return;  // every write goes to the disk
    }
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(recentKey, files.mid(0, recentFiles));
}

bool holdsCase(const QString& path) {
    try {
        CaseDocument::read(path);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

CaseDocument::CaseDocument(SceneModel* model, QObject* parent)
    : QObject(parent),
      model_(model),
      loaded_(std::make_unique<CaseFile>()),
      sourcesLater_(new QTimer(this)) {
    documents() << this;
    constexpr int delay = 300;  // ms
    sourcesLater_->setSingleShot(true);
    sourcesLater_->setInterval(delay);
    connect(sourcesLater_, &QTimer::timeout, this, &CaseDocument::watchSources);
    connect(model, &SceneModel::historyChanged, sourcesLater_, [this] { sourcesLater_->start(); });
    connect(model, &SceneModel::historyChanged, this, &CaseDocument::updateNeed);
    connect(model, &SceneModel::titleChanged, this, &CaseDocument::nameChanged);
    connect(model, &SceneModel::changed, this, [this] {
        if (QString name = model_->jobName(); name != jobName_) {
            jobName_ = std::move(name);
            Q_EMIT nameChanged();
        }
    });
    connect(model, &SceneModel::restarted, this, [this] {
        *loaded_ = {};
        setPath({}, {});
    });
}

CaseDocument::~CaseDocument() {
    documents().removeOne(this);
}

void CaseDocument::tellFiles() {
    const FileOnDisk::State state = disk_.state();
    isLastCopy_ = state == FileOnDisk::State::Missing ||
                  (state == FileOnDisk::State::Changed && !holdsCase(path_));
    updateNeed();
    Q_EMIT filesChanged();
}

bool CaseDocument::hasFile(const SceneModel& model) {
    return std::any_of(documents().begin(), documents().end(), [&](const CaseDocument* document) {
        return document->model() == &model && !document->path().isEmpty();
    });
}

void CaseDocument::updateNeed() {
    const bool needs = needsSaving();
    if (std::exchange(neededSaving_, needs) != needs) {
        Q_EMIT nameChanged();
    }
}

QString CaseDocument::name() const {
    if (!path_.isEmpty()) {
        return plainTitle(QFileInfo(path_).fileName());
    }
    // A job's title is that of the engine it was begun from, and jobs of one engine have the same.
    const QString job = model_->jobName();
    return job.isEmpty() ? model_->titleShown() : plainTitle(job);
}

QString CaseDocument::proposedPath() const {
    const QString job = asFileName(model_->jobName());
    return path_.isEmpty() ? (job.isEmpty() ? model_->sceneName() : job) + ending : path_;
}

std::string CaseDocument::asText(const QString& path) const {
    CaseFile file = model_->caseFile();
    if (!path.isEmpty()) {
        move_files(file, model_->context(), {fsPath(QFileInfo(path).absolutePath())});
    }
    return write_case(file).dump(2) + "\n";
}

bool CaseDocument::names(const QString& path) const {
    const CaseContext folder{fsPath(QFileInfo(path_).absolutePath())};
    return is_named_by(model_->caseFile(), model_->context(), fsPath(path)) ||
           (!path_.isEmpty() && is_named_by(*loaded_, folder, fsPath(path)));
}

QString sourceTrouble(const QString& path) {
    for (const CaseDocument* document : documents()) {
        const QString& own = document->path();
        if (!own.isEmpty() && is_same_file(fsPath(own), fsPath(path))) {
            return CaseDocument::tr("%1 is an open case; choose another file.").arg(path);
        }
        if (document->model()->hasCaseFile() && document->names(path)) {
            return CaseDocument::tr("%1 is a file that an open case reads; choose another file.")
                .arg(path);
        }
    }
    return {};
}

QStringList CaseDocument::recentPaths() {
    return QSettings().value(recentKey).toStringList().mid(0, recentFiles);
}

void CaseDocument::setPath(const QString& path, const QByteArray& known) {
    path_ = path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
    if (!path.isEmpty()) {
        remember(path_);
    }
    if (disk_.setPath(path_, known)) {
        tellFiles();
    }
    model_->history()->setClean();
    Q_EMIT nameChanged();
}

CaseFile CaseDocument::read(const QString& path, QByteArray* digest) {
    return withinMemory([&] {
        const std::string text = read_text_file(fsPath(path));
        if (digest != nullptr) {
            *digest = FileOnDisk::digestOf(text);
        }
        return parse_shown_case(text);
    });
}

void CaseDocument::open(const CaseFile& file, const QString& path, const QByteArray& known) {
    take(file, {fsPath(QFileInfo(path).absolutePath())});
    setPath(path, known);
}

void CaseDocument::begin(const CaseFile& file) {
    take(model_->asNew(file), {}, true);
}

void CaseDocument::take(const CaseFile& file, const CaseContext& context, bool isNamed) {
    load(file, context, isNamed);
    model_->history()->clear();  // undo must not bring another case's values under this one's name
    setPath({}, {});
}

Json* CaseDocument::fileNamedAt(CaseFile& file, const InputError& error) {
    const std::string place = error.where();
    const std::string_view root = "/input/";
    if (!place.starts_with(root) || !place.ends_with("/csv")) {
        return nullptr;
    }
    const Json::json_pointer at(place.substr(root.size() - 1));
    return file.input.contains(at) && file.input.at(at).is_string() ? &file.input.at(at) : nullptr;
}

void CaseDocument::load(const CaseFile& file, const CaseContext& context, bool isNamed) {
    withinMemory([&] {
        auto loaded = std::make_unique<CaseFile>(file);
        model_->loadFile(file, context, isNamed);
        loaded_ = std::move(loaded);
    });
    sources_.clear();  // they were read just now
    watchSources();
    Q_EMIT model_->broughtIn();
}

void CaseDocument::restore(const CaseFile& file, const RecoveredCase& from) {
    take(file, from.context);
    model_->takePlace(from.place);
    path_ = from.path;
    if (disk_.setPath(path_, from.known)) {
        tellFiles();
    }
    model_->history()->resetClean();
    Q_EMIT nameChanged();
}

QString CaseDocument::reload() {
    if (const FileOnDisk* file = changedFile(); file != nullptr && !isOwn(file)) {
        checkFiles();
        try {
            model_->loadInput(model_->inputJson(), model_->context());
        } catch (const InputError& error) {
            return errorText(error);
        }
        keepSources();
        Q_EMIT model_->broughtIn();
        return {};
    }
    QByteArray known;
    try {
        load(read(path_, &known), {fsPath(QFileInfo(path_).absolutePath())});
    } catch (const InputError& error) {
        return path_ + QStringLiteral(": ") + errorText(error);
    }
    setPath(path_, known);
    return {};
}

void CaseDocument::keepMine() {
    if (isOwn(changedFile())) {
        if (disk_.accept()) {
            tellFiles();
        }
        model_->history()->resetClean();
        Q_EMIT nameChanged();
    } else {
        keepSources();
    }
}

void CaseDocument::keepSources() {
    for (FileOnDisk& each : sources_) {
        each.accept();
    }
    Q_EMIT filesChanged();
}

void CaseDocument::watchSources() {
    sourcesLater_->stop();
    std::vector<QString> paths;
    if (model_->hasCaseFile()) {
        for (const std::filesystem::path& each :
             files_named_by(model_->caseFile(), model_->context())) {
            const QFileInfo file(QFile::decodeName(each.string().c_str()));
            paths.push_back(file.absoluteFilePath());
        }
    }
    const bool isFewer = std::erase_if(sources_, [&](const FileOnDisk& each) {
        return std::ranges::find(paths, each.path()) == paths.end();
    });
    for (const QString& path : paths) {
        if (std::ranges::find(sources_, path, &FileOnDisk::path) == sources_.end()) {
            sources_.emplace_back().setPath(path);
        }
    }
    if (isFewer) {
        Q_EMIT filesChanged();
    }
}

const FileOnDisk* CaseDocument::changedFile() const {
    if (!disk_.isSame()) {
        return &disk_;
    }
    const auto changed =
        std::ranges::find_if(sources_, [](const FileOnDisk& each) { return !each.isSame(); });
    return changed != sources_.end() ? &*changed : nullptr;
}

void CaseDocument::checkFiles() {
    bool isAnother = disk_.check();
    for (FileOnDisk& each : sources_) {
        isAnother = each.check() || isAnother;
    }
    if (isAnother) {
        tellFiles();
    }
}

QString CaseDocument::saveTo(const QString& path) {
    if (QString why = model_->keepForSaving(); !why.isEmpty()) {
        return why;
    }
    std::string text;
    try {
        const QFileInfo there(path);
        if (there.exists() && !there.isFile() && !there.isDir()) {
            throw InputError("", not_a_file);
        }
        withinMemory([&] {
            text = asText(path);
            check_text_size(text.size());
        });
        write_text_file(fsPath(path), text);
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
    setPath(path, FileOnDisk::digestOf(text));
    return {};
}

}  // namespace ravnoves
