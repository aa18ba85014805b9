#pragma once

#include "experiments/papers/transport/transport_work.hpp"

/// Tables, charts and scenes from the values of the experiment.
namespace fulbito {

ReportTable partTable(const TransportTask& task);             ///< as Table 2
ReportTable phaseTable(const Carrying& work);                 ///< as Table 1
ReportTable switchTable(const Carrying& work);                ///< where roles change
ReportTable stepTable(const std::vector<StepErrors>& steps);  ///< rod error against step
/// The printed rules beside the simulation's on one path.
ReportTable printedTable(const TransportTask& task, const std::vector<PrintedRun>& printed,
                         const Carrying& ours, double step);
ReportTable radioTable(const std::vector<RadioRun>& radios);  ///< loss, delay, silence
ReportTable randomTable(const std::vector<RandomRun>& runs);  ///< random paths
ReportTable realTable(const std::vector<RealRun>& runs);      ///< the rod in the world
ReportTable fitTable();                                       ///< polylines as lines and arcs

ReportChart speedChart(const std::string& name, const TransportTask& task,
                       const Carrying& work);  ///< as Fig. 9
ReportChart stepChart(const std::vector<StepErrors>& steps);
ReportChart curveChart(const PathWork& work);  ///< both coordinates over each other
ReportChart forceChart(const std::vector<RealRun>& runs);

/// Both robots and the rod by the messages alone: points on the path, in the colours of their roles.
ReportScene planScene(const std::string& name, const std::string& title, const TransportTask& task,
                      const Carrying& work);
/// @{ Add highlighted moments to a scene's picture: steps 1 to 8 of Table 1, as in Fig. 8, or one every
/// `every` [s], as in Fig. 10.
void showSteps(const Carrying& work, ReportScene& scene);
void showEvery(double every, ReportScene& scene);
/// @}
/// The drive in the world as a scene.
ReportScene realScene(const std::string& name, const PathWork& work, const RealRun& run);

}  // namespace fulbito
