#include <grus/sceneTables.hpp>

#include <algorithm>

#include <core/Body.hpp>
#include <core/BodyContainer.hpp>
#include <core/Omega.hpp>
#include <core/Scene.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondPhys.hpp>
#include <grus/interactionOrder.hpp>
#include <grus/require.hpp>

namespace yade {

ContactTable contactTable() {
    const Scene& scene = *Omega::instance().getScene();
    ContactTable table;
    for (const Interaction* interaction : realInOrder(*scene.interactions)) {
        const auto* phys = dynamic_cast<const BondPhys*>(interaction->phys.get());
        if (!phys)
            continue;
        const auto& geom = static_cast<const ScGeom&>(*interaction->geom);
        const auto [low, high] = std::minmax<std::int32_t>(interaction->id1, interaction->id2);
        table.ids.push_back({low, high});
        table.bonded.push_back(phys->bonded);
        table.breakage.push_back(static_cast<std::uint8_t>(phys->breakage));
        table.force.push_back(phys->normalForce.dot(geom.normal));
        table.point.push_back(geom.contactPoint);
    }
    return table;
}

BodyTable bodyTable(const std::vector<int>& ids) {
    const Scene& scene = *Omega::instance().getScene();
    BodyTable table;
    for (const int id : ids) {
        require(id >= 0 && id < static_cast<int>(scene.bodies->size()) && (*scene.bodies)[id], "bodyTable(ids)", id,
                "ids of bodies");
        const State& state = *(*scene.bodies)[id]->state;
        table.position.push_back(state.pos);
        table.velocity.push_back(state.vel);
    }
    return table;
}

namespace {

namespace py = boost::python;

template <class Row> py::object bytes(const std::vector<Row>& column) {
    const auto* first = reinterpret_cast<const char*>(column.data());
    return py::object(py::handle<>(PyBytes_FromStringAndSize(first, column.size() * sizeof(Row))));
}

py::dict contactColumns() {
    const ContactTable table = contactTable();
    py::dict columns;
    columns["ids"] = bytes(table.ids);
    columns["bonded"] = bytes(table.bonded);
    columns["breakage"] = bytes(table.breakage);
    columns["force"] = bytes(table.force);
    columns["point"] = bytes(table.point);
    return columns;
}

py::dict bodyColumns(const std::vector<int>& ids) {
    const BodyTable table = bodyTable(ids);
    py::dict columns;
    columns["position"] = bytes(table.position);
    columns["velocity"] = bytes(table.velocity);
    return columns;
}

}

void exposeSceneTables() {
    py::def("contactTable", &contactColumns,
            "Real contacts of the current scene, sorted by ids: columns as bytes; use grus.scene.contacts.");
    py::def("bodyTable", &bodyColumns, py::arg("ids"),
            "Position and velocity of the bodies: columns as bytes; use grus.scene.snapshot.");
}

}
